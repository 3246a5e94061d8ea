// SPDX-License-Identifier: GPL-3.0-or-later
// Channels that leave far more than their sensor's noise over, and not as noise does.
#pragma once

#include <vector>

#include "identification/adoption/measure.h"

namespace sinew::diagnosis {

struct UnquietChannel {
  int channel = 0;
  double times_noise = 0.0;  ///< rms left over by that of the sensor's white noise in the band
};

/// What is left over comes in bursts there, as of contacts, and is several times the sensor's noise
/// and worth explaining. Coloured noise may be large too, but is as large at all times.
std::vector<UnquietChannel> unquiet_channels(const Problem& problem,
                                             const std::vector<MeasuredChannel>& measured);

}  // namespace sinew::diagnosis

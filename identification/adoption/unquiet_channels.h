// SPDX-License-Identifier: GPL-3.0-or-later
// Channels that leave far more than their sensor's noise over, and not as noise does.
#pragma once

#include <vector>

#include "identification/diagnosis/selection.h"

namespace sinew::diagnosis {

struct UnquietChannel {
  int channel = 0;
  double times_noise = 0.0;  ///< rms left over by that of the sensor's white noise in the band
};

/// What the search's final model, with all that it always fits, leaves over of the training logs
/// comes in bursts there, as of contacts, and is several times the sensor's noise and worth
/// explaining. Coloured noise may be large too, but is as large at all times.
std::vector<UnquietChannel> unquiet_channels(const Design& design, const Selection& selection);

}  // namespace sinew::diagnosis

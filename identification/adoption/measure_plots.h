// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures that carry a verdict: what the model leaves over, against what it may depend on.
#pragma once

#include <string>
#include <vector>

#include "identification/report/findings.h"
#include "identification/adoption/measure.h"

namespace sinew::diagnosis {

/// What the pictures of a channel call their axes.
struct PlotNames {
  std::string quantity, unit;           ///< measured: "effort", "N"
  std::string position, position_unit;  ///< "position", "m"
  std::string load_unit;                ///< "N"
};

/// Time, velocity, position, load, spectrum and loop of one channel, from the held-out logs or the
/// training logs.
std::vector<Plot> channel_plots(const std::vector<MeasuredChannel>& measured, int channel,
                                bool held_out, bool revolute);
std::vector<Plot> channel_plots(const std::vector<MeasuredChannel>& measured, int channel,
                                bool held_out, const PlotNames& names);

}  // namespace sinew::diagnosis

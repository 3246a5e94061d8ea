// SPDX-License-Identifier: GPL-3.0-or-later
// The plots that carry a verdict: the residual of the model, against what it may depend on.
#pragma once

#include <string>
#include <vector>

#include "identification/adoption/measure.h"
#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// What the plots of a channel call their axes.
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

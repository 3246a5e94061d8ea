// SPDX-License-Identifier: GPL-3.0-or-later
// What of a log tells which column is which: slow motion at some thousand samples.
#pragma once

#include "identification/regression/candidate.h"

namespace sinew::diagnosis {

/// Samples at which columns are told apart.
inline constexpr Eigen::Index kMostPoints = 4000;

/// Above that nothing is looked at, at a sampling period [s]: cut-off [Hz].
double column_cutoff(double step);

/// Fewer samples than that tell nothing.
inline constexpr Eigen::Index kFewestPoints = 200;

/// Motion, targets, loads, payloads and tensions below 10 Hz, at most some kMostPoints samples,
/// away from the ends. Moment arms go along. q is empty where too little is left.
Recording slow_recording(const Recording& recording);

/// Share of the measured effort's square that the model leaves over, offset and all: 0 perfect, 1
/// as if it said nothing, more where it says too much.
double share_left_over(const Eigen::VectorXd& measured, const Eigen::VectorXd& model);

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares of many terms most of which act on one channel each.
#pragma once

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Coefficients as solve() fits them, up to rounding and to what is nearly dependent, without the
/// covariance. Each channel's own columns are eliminated before those that several channels share:
/// with the friction of every joint in many forms the normal matrix is a hundred times cheaper to
/// invert by parts than as a whole. `channel`: of each segment of the stack.
Eigen::VectorXd channelwise_coefficients(const Stack& stack, const std::vector<int>& channel);

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// Where a fit of nonlinear parameters begins.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/candidate.h"

namespace sinew::diagnosis {

/// The grid over a candidate's nonlinear parameters, the last one varying fastest; one empty vector
/// where it has none, which is the tangent where there is a secant besides.
std::vector<Eigen::VectorXd> starting_values(const Candidate& candidate);

}  // namespace sinew::diagnosis

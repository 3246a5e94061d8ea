// SPDX-License-Identifier: GPL-3.0-or-later
// Joint positions from tendon lengths where the coupling matrix changes with the pose: straight
// stretches, four-bars. Levenberg-Marquardt with a fixed number of iterations, for any mechanism
// whose tendons determine its coordinates; without a branch.
#pragma once

#include <vector>

#include "generator/function.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

struct NonlinearPositionSettings {
  int iterations = 6;
  double damping = 1e-4;         ///< λ at the start, relative to the diagonal of PᵀP
  double largest_step = 0.25;    ///< per iteration, of a coordinate's range
  double tolerance = 1e-6;       ///< rad or m; a remaining correction above this is "not converged"
  double smallest_pivot = 1e-9;  ///< of PᵀP relative to its diagonal; below: not determined
  int most_coordinates = 6;      ///< with more the straight-line code gets too long for a board
};

/// link_position(h m, q_start n -> q n, correction 1, status 1): status 0 converged, 1 not;
/// link_position_warm: the same with one iteration, from a start a tick away;
/// link_position_covariance(q n, sigma -> covariance n x n, status 1): sigma² (PᵀP)⁻¹ for
/// independent errors of the lengths of standard deviation sigma [m], status 1 where P lacks rank.
/// Nothing where the tendons do not determine the coordinates at the reference pose, or where there
/// are more than most_coordinates.
std::vector<Function> nonlinear_position_functions(const Mechanism& mechanism,
                                                   const NonlinearPositionSettings& settings = {});

}  // namespace sinew

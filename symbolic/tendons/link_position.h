// SPDX-License-Identifier: GPL-3.0-or-later
// Joint angles of the thumb's base from its tendon lengths (5.4.3, (5.24)).
//
// Four straight tendons hold the base: h_i = |T_10_12(q) p_i - p0_i| + h0_i (5.20), frame {10}
// fixed, {12} at the PIP joint, T_10_12 = Rz(q10) Rx(90°) Tx(e) Rz(q11) Rx(-90°) Tx(l). The angles
// minimise the sum of the squared errors over all four. Two methods with a fixed number of
// iterations, neither with a branch: Levenberg-Marquardt, and the gradient search of Algorithm 1,
// corrected: an accepted step keeps the new point, its cost and its gradient, a rejected one halves
// the step.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "generator/function.h"

namespace sinew {

struct ThumbBaseParameters {
  double length = 0.0;                         ///< l [m]
  double offset = 0.0;                         ///< e [m]
  std::vector<Eigen::Vector3d> base_points;    ///< p0_i in {10} [m]: A0, B0, C0, D0 of Table 5.2
  std::vector<Eigen::Vector3d> distal_points;  ///< p_i in {12} [m]: A, B, C, D
  std::vector<double> free_lengths;            ///< h0_i [m]; empty: all 0
  Range angle{0.0, 0.0};                       ///< rad, both joints
};

struct LinkPositionSettings {
  int iterations = 4;            ///< Levenberg-Marquardt
  double damping = 1e-4;         ///< λ at the start, relative to the diagonal of PᵀP
  int gradient_iterations = 50;  ///< Algorithm 1
  double gradient_step = 300.0;  ///< rad/m² at the start of Algorithm 1
  double largest_step = 0.5;     ///< rad per iteration and joint
  double tolerance = 1e-6;       ///< rad; a remaining correction above this is "not converged"
  double smallest_determinant = 1e-9;  ///< of PᵀP relative to the product of its diagonal
};

// Throw std::invalid_argument unless there are as many base as distal points, two at least.

/// link_position(h m, q_start 2 -> q 2, correction 1, status 1) by Levenberg-Marquardt: q10, q11
/// [rad]; the next step it would take [rad]; status 0 converged, 1 not.
Function link_position(const ThumbBaseParameters& base, const LinkPositionSettings& settings);
/// link_position_gradient(h m, q_start 2 -> q 2, correction 1, status 1) by Algorithm 1; the
/// correction is the Gauss-Newton step left at the result [rad].
Function link_position_gradient(const ThumbBaseParameters& base,
                                const LinkPositionSettings& settings);
/// link_position_gradient_step(h m, search 6 -> next 6): one iteration of Algorithm 1, to spread
/// the search over ticks. `search`: q10, q11, gradient (2) [m²/rad], step [rad/m²], smallest cost
/// [m²]. Start with a gradient of 0 and a cost above any, for instance 1.
Function link_position_gradient_step(const ThumbBaseParameters& base,
                                     const LinkPositionSettings& settings);
/// link_position_status(h m, q 2 -> correction 1, status 1): whether an estimate is the minimum,
/// for searches spread over ticks: the Gauss-Newton step left there [rad]; status 0 converged, 1
/// not.
Function link_position_status(const ThumbBaseParameters& base,
                              const LinkPositionSettings& settings);
/// link_position_covariance(q 2, sigma -> covariance 2x2, status 1): sigma² (PᵀP)⁻¹ [rad²] of the
/// estimate for independent length errors of standard deviation sigma [m]; status 1 where PᵀP is
/// singular.
Function link_position_covariance(const ThumbBaseParameters& base,
                                  const LinkPositionSettings& settings);
/// base_tendon_lengths(q 2 -> h m) (5.20).
Function base_tendon_lengths(const ThumbBaseParameters& base);

/// All of the above.
std::vector<Function> link_position_functions(const ThumbBaseParameters& base,
                                              const LinkPositionSettings& settings);

}  // namespace sinew

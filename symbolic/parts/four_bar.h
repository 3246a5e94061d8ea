// SPDX-License-Identifier: GPL-3.0-or-later
// Planar four-bar linkage: the hamatometacarpal joint that carries the fifth finger (5.5).
//
// Plane frame: origin at the crank's pivot, x towards the rocker's pivot. Angles are absolute and
// counter-clockwise from x: crank theta2, coupler theta3 (from the crank's end to the rocker's),
// rocker theta4. The joint locks where coupler and rocker line up, sin(theta3 - theta4) = 0.
#pragma once

#include <optional>
#include <vector>

#include "generator/function.h"

namespace sinew {

struct FourBarParameters {
  double ground = 0.0;         ///< g [m], between the fixed pivots
  double crank = 0.0;          ///< a [m]
  double coupler = 0.0;        ///< b [m]
  double rocker = 0.0;         ///< c [m]
  int branch = -1;             ///< σ: -1 open, +1 crossed, for a crank turned to positive angles
  double pulley_radius = 0.0;  ///< [m] on the crank; two antagonistic tendons
  double reference_theta2 = 0.0;  ///< rad; where the tendons have their length h0 = 0
  Range theta2{0.0, 0.0};         ///< rad; range of use
  double singular_margin = 1e-6;  ///< rad; nearer than this counts as locked
};

// Every function is defined and finite for any finite input; beyond a locking pose coupler and
// rocker stay lined up. Names are without a prefix.

/// four_bar(theta2 -> out 4): theta3, theta4 [rad] in (-π, π], dtheta3/dtheta2, dtheta4/dtheta2.
Function four_bar(const FourBarParameters& parameters);
/// locking(theta2 -> distance 1, status 1): angle [rad] between coupler and rocker, folded to
/// [0, π/2]; status 1 at or beyond a locking pose.
Function four_bar_locking(const FourBarParameters& parameters);
/// coupler_pose(theta2 -> T 4x4): coupler frame (origin at the crank's end, x along the coupler,
/// z out of the plane) to plane frame.
Function four_bar_coupler_pose(const FourBarParameters& parameters);
/// tendon_lengths(theta2 -> h 2): ±radius (theta2 - reference) [m].
Function four_bar_tendon_lengths(const FourBarParameters& parameters);

/// Which of the linkage's angles a joint has.
enum class FourBarAngle { rocker, coupler_on_crank };
/// joint(theta2 -> angle, slope, curvature 1 each): rocker angle, or coupler angle against the
/// crank, from its value at reference_theta2 [rad, in (-π, π]], and its first and second derivative
/// by theta2.
Function four_bar_joint(const FourBarParameters& parameters, FourBarAngle angle);

/// All of the above but joint.
std::vector<Function> four_bar_functions(const FourBarParameters& parameters);

/// A crank angle within theta2 at which the links do not reach or the linkage locks [rad]; nothing
/// where it closes over the whole range.
std::optional<double> unreachable_crank_angle(const FourBarParameters& parameters);

/// Crank angles in [0, π] at which the linkage locks; none if the crank turns all the way round. By
/// symmetry their negatives lock, too.
std::vector<double> locking_angles(const FourBarParameters& parameters);

}  // namespace sinew

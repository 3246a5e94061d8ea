// SPDX-License-Identifier: GPL-3.0-or-later
// Equations of motion of a mechanism whose base moves, for fingers on a palm.
//
// Argument `base` (9): angular velocity, angular acceleration and acceleration of the base's origin
// less gravity, all in the base frame [rad/s, rad/s², m/s²]. A base at rest has (0, 0, -g). The
// mechanism's own gravity is not used.
#pragma once

#include "generator/function.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// moving_base_inverse_dynamics(q, qd, qdd, base -> tau n, wrench 6): joint torques of a motion,
/// and force and moment about the base's origin that the base gives to the mechanism, in the base
/// frame [N, N·m]. It is the Lagrangian's inverse dynamics of the mechanism behind six joints
/// without mass that hold the base, at their zero.
Function moving_base_inverse_dynamics(const Mechanism& mechanism);

/// moving_base_forward_dynamics(q, qd, tau, base -> qdd): joint accelerations.
Function moving_base_forward_dynamics(const Mechanism& mechanism);

/// moving_base_mass_matrix(q -> M): of the joints alone; the same as on a resting base.
Function moving_base_mass_matrix(const Mechanism& mechanism);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of a tendon in its guides (4.2): grows with the total bending angle, not with speed.
//
// The force opposes the tendon's motion; where that reverses, v/√(v² + v_s²) takes the place of the
// jump from -1 to 1. Velocities are positive towards the motor, forces on the tendon likewise.
#pragma once

#include <vector>

#include "generator/function.h"

namespace sinew {

struct GuidingParameters {
  double C0 = 0.0;                    ///< N, fitted for one tension
  double C1 = 0.0;                    ///< 1/rad
  double friction_coefficient = 0.0;  ///< μ of the capstan law
  double reversal_velocity = 1e-4;    ///< v_s [m/s]
  Range bending{0.0, 6.3};            ///< rad
  Range velocity{-0.1, 0.1};          ///< m/s
  Range tension{0.0, 100.0};          ///< N
};

// All throw std::invalid_argument for negative friction or a reversal velocity that is not
// positive. Bending angles below 0 count as 0 and above 100 rad as 100 rad.

/// Model `guiding`: friction_force(bending, velocity -> force): C0 (1 - e^(-C1 α)) against the
/// motion [N] (4.1).
Function guiding_friction_force(const GuidingParameters& parameters);

/// Model `capstan`: friction_force(tension, bending, velocity -> force): T (1 - e^(-μ α)) against
/// the motion [N], T the tension on the pulling side.
Function capstan_friction_force(const GuidingParameters& parameters);

/// Model `capstan`: transmitted_force(tension, bending, velocity -> force): tension [N] on the
/// finger's side when it is `tension` on the motor's: T e^(∓μ α), less while the motor pulls.
Function capstan_transmitted_force(const GuidingParameters& parameters);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Outward sweep: how a link moves, in its own axes.
#pragma once

#include "symbolic/dynamics/composite_inertia.h"
#include "symbolic/dynamics/spatial.h"

namespace sinew {

/// Motion of a frame, in its own axes.
struct Motion {
  Vector3ex w;      ///< angular velocity, rad/s
  Vector3ex alpha;  ///< angular acceleration, rad/s^2
  Matrix3ex U;      ///< [alpha x] + [w x]^2: acceleration of a fixed point r is a + U r
  Vector3ex a;      ///< acceleration of the origin less gravity, m/s^2
};

/// Wrench in the axes and about the origin of a frame.
struct Wrench {
  Vector3ex F;  ///< N
  Vector3ex N;  ///< N m
};

/// Motion of a frame at rest under gravity.
Motion motion_at_rest(const Vector3ex& gravity);

/// Motion of a frame fixed in another at pose (R, p).
Motion fixed_frame_motion(DefinitionList& list, const std::string& name, const Motion& carrier,
                          const NumberMatrix3& R, const NumberVector3& p);

/// Motion after a rotation about z by `angle` at rate `qd`, `qdd`. Column z of U only turns: points
/// on the axis do not notice the rotation.
Motion turned_motion(DefinitionList& list, const std::string& name, const Motion& before,
                     const CosSin& angle, const GiNaC::ex& qd, const GiNaC::ex& qdd);

/// Motion after a translation q along z.
Motion slid_motion(DefinitionList& list, const std::string& name, const Motion& before,
                   const GiNaC::ex& q, const GiNaC::ex& qd, const GiNaC::ex& qdd);

/// U from w and alpha, given that column z is known.
void complete_rotation_rates(DefinitionList& list, const std::string& name, Motion& motion);

/// Inertial wrench of a link: F = U s + m a, N = vee(U J - J U^T) + s x a.
Wrench inertial_wrench(DefinitionList& list, const std::string& name, const PseudoInertia& J,
                       const Motion& motion);

/// Adds a wrench given in a frame at pose (R, offset) to `total`.
void add_wrench(DefinitionList& list, const std::string& name, Wrench& total, const Wrench& part,
                const NumberMatrix3& R, const Vector3ex& offset);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of motion as a textbook writes them (5.4): L = T - V link by link, then
// tau = d/dt dL/dqd - dL/dq by differentiating what was written down. An independent statement of
// what recursive_lagrangian.h computes more cheaply; joint couplings enter through L itself, the
// second method of 5.3.2.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/dynamics/spatial.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/vector3.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// What a mechanism's files say of its bodies, as expressions: numbers, or symbols that keep the
/// equations readable.
struct MechanismValues {
  struct OfJoint {
    Matrix3ex rotation;   ///< of its origin
    Vector3 translation;  ///< m
    Vector3 axis;
  };
  struct OfBody {
    GiNaC::ex mass;     ///< kg
    Vector3 centre;     ///< m
    Matrix3ex inertia;  ///< kg m^2, about the centre
  };
  std::vector<OfJoint> joints;
  std::vector<OfBody> bodies;
  Vector3 gravity;  ///< m/s^2
};

/// The numbers as they are.
MechanismValues exact_values(const Mechanism& mechanism);

/// Where a body is: its frame against its parent's, and in the base frame.
struct LinkPose {
  Matrix3ex to_parent;
  Vector3 offset;
  Matrix3ex R;
  Vector3 p;
};

/// In body axes.
struct LinkVelocity {
  Vector3 spin, velocity;
};

/// Of every body, from the positions of all moving joints, written as definitions
/// <joint>_cos, _sin, _R_x.., _p_x...
std::vector<LinkPose> link_poses(DefinitionList& list, const Mechanism& mechanism,
                                 const MechanismValues& values,
                                 const std::vector<GiNaC::ex>& position);

/// Of every body, from the rates of all moving joints: <joint>_w<suffix>_x.., _v<suffix>_x...
std::vector<LinkVelocity> link_velocities(DefinitionList& list, const Mechanism& mechanism,
                                          const MechanismValues& values,
                                          const std::vector<LinkPose>& poses,
                                          const std::vector<GiNaC::ex>& rate,
                                          const std::string& suffix = "");

/// L = T - V [J] from poses and velocities: <body>_vc_x.. (of the centre of mass), <body>_L, L.
GiNaC::ex lagrangian(DefinitionList& list, const Mechanism& mechanism,
                     const MechanismValues& values, const std::vector<LinkPose>& poses,
                     const std::vector<LinkVelocity>& velocities);

/// L = T - V [J] with T = 1/2 sum (m v^T v + w^T I w) and V = -sum m g^T p, written as definitions.
/// `q`, `qd`: the mechanism's coordinates and their rates; a coupled joint has none of its own.
GiNaC::ex lagrangian(DefinitionList& list, const Mechanism& mechanism,
                     const std::vector<GiNaC::symbol>& q, const std::vector<GiNaC::symbol>& qd);

/// inverse_dynamics(q, qd, qdd -> tau) from it: generalised forces [N m, N].
Function textbook_inverse_dynamics(const Mechanism& mechanism);

/// The first method of 5.3.2: the model without couplings, its joints' motion replaced by what they
/// follow, and its torques projected on the coordinates, J^T tau. The second one is
/// textbook_inverse_dynamics, where the couplings stand in L itself.
Function projected_inverse_dynamics(const Mechanism& mechanism);

}  // namespace sinew

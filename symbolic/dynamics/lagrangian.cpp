// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/lagrangian.h"

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/dynamics/spatial.h"
#include "symbolic/dynamics/symbols.h"

namespace sinew {
namespace {

using GiNaC::ex;

Matrix3ex exact_matrix(const Eigen::Matrix3d& values) {
  Matrix3ex result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result[i][j] =
          exact_number(values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  return result;
}

Matrix3ex product(const Matrix3ex& A, const Matrix3ex& B) {
  Matrix3ex result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += A[i][k] * B[k][j];
  return result;
}

Matrix3ex transposed(const Matrix3ex& A) {
  Matrix3ex result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = A[j][i];
  return result;
}

/// Rotation about a unit axis: cos 1 + (1 - cos) a a^T + sin [a]x.
Matrix3ex turned_about(const Vector3& a, const ex& c, const ex& s) {
  Matrix3ex R;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) R[i][j] = (1 - c) * a[i] * a[j] + (i == j ? c : ex(0));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    R[i][j] -= s * a[k];
    R[j][i] += s * a[k];
  }
  return R;
}

/// Motion of a body's frame: pose in the base frame, velocities in body axes.
struct LinkState {
  Matrix3ex R;
  Vector3 p, velocity, spin;
};

LinkState base_state() {
  LinkState base;
  base.R = exact_matrix(Eigen::Matrix3d::Identity());
  base.p = base.velocity = base.spin = zero_vector();
  return base;
}

/// The next link outwards, its joint at `q` with the rate `qd`.
LinkState next(DefinitionList& list, const Joint& joint, const LinkState& parent, const ex& q,
               const ex& qd) {
  const Vector3 axis = exact_vector(joint.axis), at = exact_vector(joint.origin.translation);
  const bool turns = joint.type == JointType::revolute, slides = joint.type == JointType::prismatic;
  Matrix3ex to_parent = exact_matrix(joint.origin.rotation);
  const Vector3 offset = slides ? at + times(to_parent, q * axis) : at;
  if (turns)
    to_parent = product(to_parent, turned_about(axis, list.define(joint.name + "_cos", cos(q)),
                                                list.define(joint.name + "_sin", sin(q))));
  const Matrix3ex back = transposed(to_parent);
  LinkState link;
  link.R = product(parent.R, to_parent);
  for (Vector3ex& row : link.R) row = define(list, joint.name + "_R", row);
  link.p = define(list, joint.name + "_p", parent.p + times(parent.R, offset));
  link.spin = times(back, parent.spin);
  link.velocity = times(back, parent.velocity + cross(parent.spin, offset));
  if (turns) link.spin = link.spin + qd * axis;
  if (slides) link.velocity = link.velocity + qd * axis;
  link.spin = define(list, joint.name + "_w", link.spin);
  link.velocity = define(list, joint.name + "_v", link.velocity);
  return link;
}

/// Kinetic minus potential energy of one body.
ex energy(DefinitionList& list, const Body& body, const LinkState& link, const Vector3& gravity) {
  const Vector3 centre = exact_vector(body.centre_of_mass);
  const Vector3 v = define(list, body.name + "_vc", link.velocity + cross(link.spin, centre));
  const ex m = exact_number(body.mass);
  const ex kinetic =
      (m * dot(v, v) + dot(link.spin, times(exact_matrix(body.inertia), link.spin))) / 2;
  const ex potential = -m * dot(gravity, link.p + times(link.R, centre));
  return list.define(body.name + "_L", kinetic - potential);
}

}  // namespace

ex lagrangian(DefinitionList& list, const Mechanism& mechanism, const std::vector<GiNaC::symbol>& q,
              const std::vector<GiNaC::symbol>& qd) {
  const Coordinates coordinates(mechanism);
  const JointMap joints = coordinates.at(list, {q.begin(), q.end()});
  const std::vector<ex> position = joints.positions(),
                        rate = joints.velocities({qd.begin(), qd.end()});
  const std::vector<int> moving = coordinate_of_joint(mechanism);
  const Vector3 gravity = exact_vector(mechanism.gravity);
  std::vector<LinkState> links;
  ex L = 0;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const LinkState parent =
        joint.parent < 0 ? base_state() : links[static_cast<std::size_t>(joint.parent)];
    const auto k = static_cast<std::size_t>(moving[i]);
    links.push_back(moving[i] < 0 ? next(list, joint, parent, 0, 0)
                                  : next(list, joint, parent, position[k], rate[k]));
    L += energy(list, mechanism.bodies[i], links.back(), gravity);
  }
  return list.define("L", L);
}

Function textbook_inverse_dynamics(const Mechanism& mechanism) {
  const Argument q = joint_positions(mechanism), qd = joint_velocities(mechanism),
                 qdd = joint_accelerations(mechanism);
  DefinitionList list;
  const ex L = lagrangian(list, mechanism, q.symbols, qd.symbols);
  const std::vector<ex> momentum = gradient(list, L, qd.symbols, "p"),
                        by_position = gradient(list, L, q.symbols, "f");
  ForwardDerivative by_time(list, GiNaC::symbol("t"), "t");
  for (std::size_t i = 0; i < q.symbols.size(); ++i) {
    by_time.seed(q.symbols[i], qd.symbols[i]);
    by_time.seed(qd.symbols[i], qdd.symbols[i]);
  }
  std::vector<ex> tau;
  for (std::size_t i = 0; i < momentum.size(); ++i)
    tau.push_back(by_time.of(momentum[i]) - by_position[i]);
  return {"inverse_dynamics",
          "Generalised forces by differentiating L = T - V.",
          "(5.3)",
          {q, qd, qdd},
          list.items(),
          {{"tau", q.rows, 1, tau, torque_unit(mechanism), "joint torques"}}};
}

Function projected_inverse_dynamics(const Mechanism& mechanism) {
  Mechanism open = mechanism;
  open.couplings.clear();
  open.four_bars.clear();
  const Function whole = textbook_inverse_dynamics(open);
  const Argument q = joint_positions(mechanism), qd = joint_velocities(mechanism),
                 qdd = joint_accelerations(mechanism);
  const std::vector<ex> rate(qd.symbols.begin(), qd.symbols.end());
  DefinitionList list;
  const JointMap joints = Coordinates(mechanism).at(list, {q.symbols.begin(), q.symbols.end()});
  std::vector<ex> inputs = joints.positions();
  for (const auto& part :
       {joints.velocities(rate),
        joints.accelerations(list, rate, {qdd.symbols.begin(), qdd.symbols.end()})})
    for (const ex& value : part) inputs.push_back(list.define("joint_motion", value));
  const std::vector<ex> tau = joints.projected(inlined(list, whole, inputs)[0]);
  return {"inverse_dynamics", "Generalised forces of all joints, substituted and projected.",
          "(5.17)",           {q, qd, qdd},
          list.items(),       {{"tau", q.rows, 1, tau, torque_unit(mechanism), "joint torques"}}};
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/lagrangian.h"

#include <fmt/format.h>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/spatial.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/inline_function.h"

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

/// The base, which does not move.
LinkPose resting_base() {
  LinkPose base;
  base.R = exact_matrix(Eigen::Matrix3d::Identity());
  base.p = zero_vector();
  return base;
}

/// The joint's pose in its parent's frame, at position `q`.
void place(DefinitionList& list, const Joint& joint, const MechanismValues::OfJoint& values,
           const ex& q, LinkPose& link) {
  link.to_parent = values.rotation;
  link.offset = values.translation;
  if (joint.type == JointType::prismatic)
    link.offset = link.offset + times(link.to_parent, q * values.axis);
  if (joint.type == JointType::revolute)
    link.to_parent =
        product(link.to_parent, turned_about(values.axis, list.define(joint.name + "_cos", cos(q)),
                                             list.define(joint.name + "_sin", sin(q))));
}

/// Kinetic minus potential energy of one body.
ex energy(DefinitionList& list, const std::string& name, const MechanismValues::OfBody& body,
          const LinkPose& pose, const LinkVelocity& link, const Vector3& gravity) {
  const Vector3 v = define(list, name + "_vc", link.velocity + cross(link.spin, body.centre));
  const ex kinetic = (body.mass * dot(v, v) + dot(link.spin, times(body.inertia, link.spin))) / 2;
  const ex potential = -body.mass * dot(gravity, pose.p + times(pose.R, body.centre));
  return list.define(name + "_L", kinetic - potential);
}

}  // namespace

MechanismValues exact_values(const Mechanism& mechanism) {
  MechanismValues values;
  for (const Joint& joint : mechanism.joints)
    values.joints.push_back({exact_matrix(joint.origin.rotation),
                             exact_vector(joint.origin.translation), exact_vector(joint.axis)});
  for (const Body& body : mechanism.bodies)
    values.bodies.push_back(
        {exact_number(body.mass), exact_vector(body.centre_of_mass), exact_matrix(body.inertia)});
  values.gravity = exact_vector(mechanism.gravity);
  return values;
}

std::vector<LinkPose> link_poses(DefinitionList& list, const Mechanism& mechanism,
                                 const MechanismValues& values, const std::vector<ex>& position) {
  const std::vector<int> moving = coordinate_of_joint(mechanism);
  std::vector<LinkPose> links;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const LinkPose parent =
        joint.parent < 0 ? resting_base() : links[static_cast<std::size_t>(joint.parent)];
    LinkPose link;
    place(list, joint, values.joints[i],
          moving[i] < 0 ? ex(0) : position[static_cast<std::size_t>(moving[i])], link);
    link.R = product(parent.R, link.to_parent);
    const char* axes[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k)
      link.R[k] = define(list, fmt::format("{}_R_{}", joint.name, axes[k]), link.R[k]);
    link.p = define(list, joint.name + "_p", parent.p + times(parent.R, link.offset));
    links.push_back(std::move(link));
  }
  return links;
}

std::vector<LinkVelocity> link_velocities(DefinitionList& list, const Mechanism& mechanism,
                                          const MechanismValues& values,
                                          const std::vector<LinkPose>& poses,
                                          const std::vector<ex>& rate, const std::string& suffix) {
  const std::vector<int> moving = coordinate_of_joint(mechanism);
  std::vector<LinkVelocity> links;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const LinkVelocity parent = joint.parent < 0 ? LinkVelocity{zero_vector(), zero_vector()}
                                                 : links[static_cast<std::size_t>(joint.parent)];
    const Matrix3ex back = transposed(poses[i].to_parent);
    LinkVelocity link{times(back, parent.spin),
                      times(back, parent.velocity + cross(parent.spin, poses[i].offset))};
    if (moving[i] >= 0) {
      const ex& qd = rate[static_cast<std::size_t>(moving[i])];
      Vector3& moved = joint.type == JointType::revolute ? link.spin : link.velocity;
      moved = moved + qd * values.joints[i].axis;
    }
    link.spin = define(list, joint.name + "_w" + suffix, link.spin);
    link.velocity = define(list, joint.name + "_v" + suffix, link.velocity);
    links.push_back(std::move(link));
  }
  return links;
}

ex lagrangian(DefinitionList& list, const Mechanism& mechanism, const MechanismValues& values,
              const std::vector<LinkPose>& poses, const std::vector<LinkVelocity>& velocities) {
  ex L = 0;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    L += energy(list, mechanism.bodies[i].name, values.bodies[i], poses[i], velocities[i],
                values.gravity);
  return list.define("L", L);
}

ex lagrangian(DefinitionList& list, const Mechanism& mechanism, const std::vector<GiNaC::symbol>& q,
              const std::vector<GiNaC::symbol>& qd) {
  const JointMap joints = Coordinates(mechanism).at(list, {q.begin(), q.end()});
  const MechanismValues values = exact_values(mechanism);
  const std::vector<LinkPose> poses = link_poses(list, mechanism, values, joints.positions());
  return lagrangian(
      list, mechanism, values, poses,
      link_velocities(list, mechanism, values, poses, joints.velocities({qd.begin(), qd.end()})));
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/random_mechanism.h"

#include <string>

#include "tests/reference/random_numbers.h"

namespace sinew::reference {
namespace {

/// A box with the given edges [m], turned arbitrarily.
Eigen::Matrix3d box_inertia(RandomNumbers& random, double mass, const Eigen::Vector3d& edges) {
  const Eigen::Vector3d squares = edges.cwiseProduct(edges);
  const Eigen::Vector3d diagonal =
      mass / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  if (random.chance(0.3)) return diagonal.asDiagonal();
  const Eigen::Matrix3d turn = random.rotation();
  const Eigen::Matrix3d inertia = turn * diagonal.asDiagonal() * turn.transpose();
  return (inertia + inertia.transpose()) / 2.0;
}

Body random_body(RandomNumbers& random, int index, bool arm) {
  const double size = arm ? 0.3 : 0.04;
  Body body;
  body.name = "body" + std::to_string(index);
  body.mass = (arm ? 3.0 : 0.006) * random.uniform(0.5, 1.5);
  if (!random.chance(0.15)) body.centre_of_mass = random.vector(0.5 * size);
  const double length = random.uniform(0.5, 1.0) * size;
  body.inertia =
      box_inertia(random, body.mass,
                  {length, random.uniform(0.2, 0.5) * size, random.uniform(0.2, 0.5) * size});
  return body;
}

/// Quarter turns give the parallel and perpendicular axes that real mechanisms are made of.
Eigen::Matrix3d quarter_turns(RandomNumbers& random) {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  for (int step = random.index(3); step > 0; --step) {
    const int axis = random.index(3);
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    Eigen::Matrix3d quarter = Eigen::Matrix3d::Zero();
    quarter(axis, axis) = 1.0;
    quarter(last, next) = 1.0;
    quarter(next, last) = -1.0;
    turn = turn * quarter;
  }
  return turn;
}

Transform random_origin(RandomNumbers& random, bool arm) {
  const double size = arm ? 0.3 : 0.04;
  Transform origin;
  origin.rotation = random.chance(0.7) ? quarter_turns(random) : random.rotation();
  const int kind = random.index(4);
  if (kind == 1) origin.translation = Eigen::Vector3d::Unit(random.index(3)) * size;
  if (kind >= 2) origin.translation = random.vector(size);
  return origin;
}

JointType random_type(RandomNumbers& random, int index, const RandomMechanismOptions& options) {
  // One of each kind is certain; where they sit is not.
  if (options.joints >= 3 && options.prismatic > 0 && index == options.joints / 2)
    return JointType::prismatic;
  if (options.joints >= 3 && options.fixed > 0 && index == options.joints / 2 - 1)
    return JointType::fixed;
  const double draw = random.uniform(0.0, 1.0);
  if (draw < options.prismatic) return JointType::prismatic;
  if (draw < options.prismatic + options.fixed) return JointType::fixed;
  return JointType::revolute;
}

Joint random_joint(RandomNumbers& random, int index, const RandomMechanismOptions& options) {
  Joint joint;
  joint.name = "joint" + std::to_string(index);
  joint.type = random_type(random, index, options);
  joint.parent = index - 1;
  if (options.branched && index >= 2 && random.chance(0.4)) joint.parent = -2;
  joint.origin = random_origin(random, options.arm);
  const int kind = random.index(3);
  if (kind == 1) {
    const auto along = random.index(3);
    joint.axis = Eigen::Vector3d::Unit(along) * (random.chance(0.5) ? 1 : -1);
  }
  if (kind == 2) joint.axis = random.direction();
  if (joint.type == JointType::prismatic) {
    joint.low = options.arm ? -0.3 : -0.03;
    joint.high = -joint.low;
    joint.max_velocity = options.arm ? 1.0 : 0.3;
    joint.max_acceleration = options.arm ? 10.0 : 5.0;
  }
  return joint;
}

/// Depth-first order: a new body hangs on the newest one or on one of its ancestors.
int branch_parent(RandomNumbers& random, const std::vector<Joint>& joints) {
  int parent = static_cast<int>(joints.size()) - 1;
  for (int climb = 1 + random.index(3); climb > 0 && parent >= 0; --climb)
    parent = joints[static_cast<std::size_t>(parent)].parent;
  return parent;
}

int moving_joints(const Mechanism& mechanism) {
  int count = 0;
  for (const Joint& joint : mechanism.joints) count += joint.type != JointType::fixed;
  return count;
}

Tendon random_tendon(RandomNumbers& random, int index, const Mechanism& mechanism) {
  Tendon tendon;
  tendon.name = "tendon" + std::to_string(index);
  const bool always = index < moving_joints(mechanism);
  int coordinate = 0;
  for (const Joint& joint : mechanism.joints) {
    if (joint.type == JointType::fixed) continue;
    const double size = random.uniform(0.003, 0.008);
    const double radius = random.chance(0.5) ? size : -size;
    // The first n tendons reach one joint more each, so that P has full rank.
    if ((always && coordinate == index) || (coordinate < index && random.chance(0.3)))
      tendon.pulleys.push_back({joint.name, radius});
    ++coordinate;
  }
  if (tendon.pulleys.empty()) tendon.pulleys.push_back({mechanism.joints.back().name, 0.005});
  return tendon;
}

}  // namespace

Mechanism random_mechanism(std::uint64_t seed, const RandomMechanismOptions& options) {
  RandomNumbers random(seed);
  Mechanism mechanism;
  mechanism.name = "random" + std::to_string(seed);
  mechanism.description = "a random mechanism";
  mechanism.gravity = 9.81 * random.direction();
  for (int i = 0; i < options.joints; ++i) {
    Joint joint = random_joint(random, i, options);
    if (joint.parent == -2) joint.parent = branch_parent(random, mechanism.joints);
    mechanism.joints.push_back(joint);
    mechanism.bodies.push_back(random_body(random, i, options.arm));
  }
  if (mechanism.joints.back().type == JointType::fixed)
    mechanism.joints.back().type = JointType::revolute;
  Frame tip;
  tip.name = "tip";
  tip.body = mechanism.bodies.back().name;
  tip.pose = random_origin(random, options.arm);
  mechanism.frames.push_back(tip);
  for (int i = 0; i < options.tendons; ++i)
    mechanism.tendons.push_back(random_tendon(random, i, mechanism));
  return mechanism;
}

}  // namespace sinew::reference

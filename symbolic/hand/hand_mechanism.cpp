// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/hand/hand_mechanism.h"

#include <Eigen/Geometry>
#include <cmath>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/hand/hand_poses.h"

namespace sinew {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d pose_from(const std::vector<double>& values, std::size_t first) {
  Isometry3d pose = Isometry3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      pose(row, column) = values.at(first + static_cast<std::size_t>(4 * row + column));
  return pose;
}

/// The same doubles on every run.
std::vector<double> values_of(const Function& function, const std::vector<double>& inputs) {
  std::vector<GiNaC::numeric> exact;
  for (const double input : inputs) exact.push_back(binary_fraction(input));
  std::vector<double> values;
  for (const GiNaC::numeric& value : evaluate_precisely(function, exact))
    values.push_back(value.to_double());
  return values;
}

/// Bar angles to a microradian, which no last digit of the machine's functions changes.
std::vector<double> bar_angles(const WristParameters& wrist) {
  return {std::round(1e6 * reference_q71(wrist)) / 1e6,
          std::round(1e6 * reference_q73(wrist)) / 1e6};
}

/// Pose of the tip in the finger's base, all joints at zero.
Isometry3d tip_at_zero(const Mechanism& finger) {
  const auto moved = [](const Transform& t) {
    Isometry3d pose = Isometry3d::Identity();
    pose.linear() = t.rotation;
    pose.translation() = t.translation;
    return pose;
  };
  const Frame& tip = finger.frames.front();
  Isometry3d pose = moved(tip.pose);
  int body = -1;
  for (std::size_t i = 0; i < finger.bodies.size(); ++i)
    if (finger.bodies[i].name == tip.body) body = static_cast<int>(i);
  while (body >= 0) {
    const Joint& joint = finger.joints[static_cast<std::size_t>(body)];
    pose = moved(joint.origin) * pose;
    body = joint.parent;
  }
  return pose;
}

/// The fingers' bases on the palm: where their tips are, and back along the fingers.
std::vector<Isometry3d> bases(const Hand& hand) {
  const Function tips = hand_fingertips(hand);
  std::vector<double> inputs(static_cast<std::size_t>(tips.inputs.front().rows), 0.0);
  if (hand.has_four_bar())
    inputs.back() = 0.5 * (hand.four_bar.theta2.low + hand.four_bar.theta2.high);
  for (const double angle : bar_angles(hand.wrist)) inputs.push_back(angle);
  const std::vector<double> in_palm = values_of(tips, inputs);
  std::vector<Isometry3d> result;
  for (std::size_t k = 0; k < hand.fingers.size(); ++k)
    result.push_back(pose_from(in_palm, 16 * k) * tip_at_zero(hand.fingers[k].mechanism).inverse());
  return result;
}

/// Appends a finger with its names behind its own.
void add_finger(const Mechanism& finger, const Isometry3d& base, Mechanism& hand) {
  const std::string prefix = finger.name + "_";
  const auto named = [&](const std::string& name) { return name == "base" ? name : prefix + name; };
  const auto offset = static_cast<int>(hand.bodies.size());
  for (Body body : finger.bodies) {
    body.name = prefix + body.name;
    hand.bodies.push_back(body);
  }
  for (Joint joint : finger.joints) {
    joint.name = prefix + joint.name;
    if (joint.parent < 0) {
      joint.origin.translation = base * joint.origin.translation;
      joint.origin.rotation = base.linear() * joint.origin.rotation;
    } else {
      joint.parent += offset;
    }
    hand.joints.push_back(joint);
  }
  for (Tendon tendon : finger.tendons) {
    tendon.name = prefix + tendon.name;
    for (PulleyRouting& pulley : tendon.pulleys) pulley.joint = prefix + pulley.joint;
    for (StraightRouting& straight : tendon.straights) {
      if (straight.from_body == "base") straight.from = base * straight.from;
      if (straight.to_body == "base") straight.to = base * straight.to;
      straight.from_body = named(straight.from_body);
      straight.to_body = named(straight.to_body);
    }
    hand.tendons.push_back(tendon);
  }
  for (JointCoupling coupling : finger.couplings) {
    coupling.dependent = prefix + coupling.dependent;
    coupling.independent = prefix + coupling.independent;
    hand.couplings.push_back(coupling);
  }
}

}  // namespace

HeldHand held_hand(const Hand& hand) {
  HeldHand held;
  held.mechanism.name = hand.name;
  held.mechanism.description = hand.description;
  const Isometry3d wrist = pose_from(values_of(wrist_pose(hand.wrist), bar_angles(hand.wrist)), 0);
  held.palm = wrist.linear();
  held.mechanism.gravity = wrist.linear().transpose() * Vector3d(0.0, 0.0, -9.81);
  const std::vector<Isometry3d> base = bases(hand);
  for (std::size_t k = 0; k < hand.fingers.size(); ++k) {
    const HandFinger& finger = hand.fingers[k];
    add_finger(finger.mechanism, base[k], held.mechanism);
    held.channels.insert(held.channels.end(), finger.channels.begin(), finger.channels.end());
  }
  held.coordinates = coordinate_names(hand);
  if (hand.has_four_bar()) held.coordinates.pop_back();  // the crank's
  return held;
}

}  // namespace sinew

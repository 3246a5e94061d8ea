// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/hand/hand_poses.h"

#include "symbolic/expressions/argument.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/hand/hand_members.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/dynamics/kinematics.h"
#include "symbolic/dynamics/symbols.h"

namespace sinew {
namespace {

using GiNaC::ex;

PoseEx product(DefinitionList& list, const std::string& name, const PoseEx& a, const PoseEx& b) {
  PoseEx result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const ex sum = a.R[i][0] * b.R[0][j] + a.R[i][1] * b.R[1][j] + a.R[i][2] * b.R[2][j];
      result.R[i][j] = list.define(name, sum);
    }
    result.p[i] =
        list.define(name, a.R[i][0] * b.p[0] + a.R[i][1] * b.p[1] + a.R[i][2] * b.p[2] + a.p[i]);
  }
  return result;
}

void append(std::vector<ex>& rows, const PoseEx& pose) {
  for (std::size_t i = 0; i < 3; ++i) {
    rows.insert(rows.end(), pose.R[i].begin(), pose.R[i].end());
    rows.push_back(pose.p[i]);
  }
  rows.insert(rows.end(), {0, 0, 0, 1});
}

PoseEx wrist_in(HandStart& start) {
  return from_homogeneous(
      inlined(start.list, wrist_pose(start.hand.wrist), start.wrist_inputs())[0]);
}

/// The coupler's frame in the palm; the palm's own where there is no four-bar.
PoseEx coupler_in(HandStart& start) {
  if (!start.hand.has_four_bar()) return from_transform({});
  const ex crank = start.q.symbols.back();
  const PoseEx in_plane =
      from_homogeneous(inlined(start.list, four_bar_coupler_pose(start.hand.four_bar), {crank})[0]);
  return product(start.list, "coupler", from_transform(start.hand.four_bar_base), in_plane);
}

/// Base of a finger in the palm.
PoseEx base_in(HandStart& start, const HandFinger& finger, const PoseEx& coupler) {
  const PoseEx base = from_transform(finger.base);
  return finger.on_coupler ? product(start.list, "base", coupler, base) : base;
}

PoseEx tip_in_base(HandStart& start, const HandFinger& finger, std::size_t first) {
  const Mechanism& mechanism = finger.mechanism;
  const Coordinates coordinates(mechanism);
  const auto own = start.member_symbols(first, static_cast<std::size_t>(coordinates.count()));
  const JointTree tree = build_joint_tree(mechanism);
  Kinematics kinematics(start.list, tree,
                        coordinates.at(start.list, {own.begin(), own.end()}).positions());
  Frame tip;
  tip.body = mechanism.bodies.back().name;
  if (!mechanism.frames.empty()) tip = mechanism.frames.front();
  int body = -1;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
    if (mechanism.bodies[i].name == tip.body) body = static_cast<int>(i);
  return kinematics.frame("tip", body, tip.pose);
}

}  // namespace

Function hand_fingertips(const Hand& hand) {
  HandStart start(hand);
  const PoseEx palm = wrist_in(start), coupler = coupler_in(start);
  std::vector<ex> in_palm, in_forearm;
  std::size_t first = 0;
  for (const HandFinger& finger : hand.fingers) {
    const PoseEx tip = tip_in_base(start, finger, first);
    const PoseEx placed = product(start.list, "placed", base_in(start, finger, coupler), tip);
    append(in_palm, placed);
    append(in_forearm, product(start.list, "seen", palm, placed));
    first += static_cast<std::size_t>(Coordinates(finger.mechanism).count());
  }
  const int rows = 4 * static_cast<int>(hand.fingers.size());
  return {"fingertips",
          "Poses of the fingertips, homogeneous, one below the other in the order of the fingers.",
          "",
          {start.q, start.q_wrist},
          start.list.items(),
          {{"in_palm", rows, 4, in_palm, "1 and m", "map the tips' frames to {ABC}"},
           {"in_forearm", rows, 4, in_forearm, "1 and m", "map the tips' frames to {0}"}}};
}

Function hand_finger_gravity(const Hand& hand) {
  HandStart start(hand);
  const Argument gravity =
      array_argument("gravity", 3, 1, "m/s^2", {-9.81, 9.81}, "in the forearm frame {0}");
  const PoseEx palm = wrist_in(start), coupler = coupler_in(start);
  const auto turned_back = [&](const PoseEx& pose, const Vector3ex& v) {
    Vector3ex result;
    for (std::size_t j = 0; j < 3; ++j)
      result[j] = start.list.define(
          "turned", pose.R[0][j] * v[0] + pose.R[1][j] * v[1] + pose.R[2][j] * v[2]);
    return result;
  };
  const Vector3ex in_palm =
      turned_back(palm, {gravity.symbols[0], gravity.symbols[1], gravity.symbols[2]});
  std::vector<ex> g;
  for (const HandFinger& finger : hand.fingers) {
    const Vector3ex own = turned_back(base_in(start, finger, coupler), in_palm);
    g.insert(g.end(), own.begin(), own.end());
  }
  return {"finger_gravity",
          "Gravity in the base frame of each finger.",
          "",
          {start.q, start.q_wrist, gravity},
          start.list.items(),
          {{"g", static_cast<int>(hand.fingers.size()), 3, g, "m/s^2",
            "one row a finger, in their order"}}};
}

}  // namespace sinew

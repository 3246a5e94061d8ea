// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/hand/hand_dynamics.h"

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/recursive_lagrangian.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/hand/hand_members.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// One argument of all fingers, in their order.
Argument joined(const Hand& hand, const std::string& name, const std::string& unit,
                const std::string& doc, Argument (*of_finger)(const Mechanism&)) {
  std::vector<Range> ranges;
  for (const HandFinger& finger : hand.fingers) {
    const Argument own = of_finger(finger.mechanism);
    ranges.insert(ranges.end(), own.ranges.begin(), own.ranges.end());
  }
  Argument all = array_argument(name, static_cast<int>(ranges.size()), 1, unit, {0, 0}, doc);
  all.ranges = ranges;
  return all;
}

std::vector<ex> part(const Argument& argument, std::size_t first, std::size_t count) {
  const auto begin = argument.symbols.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

/// Of one finger whose gravity is `g`.
std::vector<ex> torques(DefinitionList& list, const Mechanism& mechanism, const std::vector<ex>& q,
                        const std::vector<ex>& qd, const std::vector<ex>& qdd,
                        const std::vector<ex>& g) {
  JointTree tree = build_joint_tree(mechanism);
  tree.gravity_vector = {g[0], g[1], g[2]};
  const JointMap joints = Coordinates(mechanism).at(list, q);
  const JointState state{joints.positions(), joints.velocities(qd),
                         joints.accelerations(list, qd, qdd)};
  return joints.projected(inverse_dynamics(list, tree, {}, state));
}

}  // namespace

Function hand_inverse_dynamics(const Hand& hand) {
  const Argument q = joined(hand, "q", "rad", "coordinates of the fingers", joint_positions);
  const Argument qd = joined(hand, "qd", "rad/s", "their rates", joint_velocities);
  const Argument qdd = joined(hand, "qdd", "rad/s^2", "accelerations", joint_accelerations);
  const int fingers = static_cast<int>(hand.fingers.size());
  const Argument g = array_argument("g", fingers, 3, "m/s^2", {-9.81, 9.81},
                                    "gravity in the base frame of each finger, one row a finger");
  DefinitionList list;
  std::vector<ex> tau;
  std::size_t first = 0, row = 0;
  for (const HandFinger& finger : hand.fingers) {
    const auto count = static_cast<std::size_t>(Coordinates(finger.mechanism).count());
    const std::vector<ex> own =
        torques(list, finger.mechanism, part(q, first, count), part(qd, first, count),
                part(qdd, first, count), part(g, row, 3));
    tau.insert(tau.end(), own.begin(), own.end());
    first += count;
    row += 3;
  }
  return {
      "inverse_dynamics",
      "Joint torques that a motion of the fingers takes, each on a base at rest: M(q) qdd + "
      "C(q,qd) qd + g(q).",
      "(2.1)",
      {q, qd, qdd, g},
      list.items(),
      {{"tau", static_cast<int>(tau.size()), 1, tau, "N m", "of the fingers, without a crank"}}};
}

Function hand_wrist_passage(const Hand& hand) {
  HandStart start(hand);
  const std::vector<ex> h =
      inlined(start.list, wrist_tendon_lengths(hand.wrist), start.wrist_inputs())[0];
  const std::vector<ex> P =
      inlined(start.list, wrist_tendon_jacobian(hand.wrist), start.wrist_inputs())[0];
  const int channels = static_cast<int>(start.channels());
  return {"wrist_passage",
          "Lengths of all tendons through the wrist, and their derivatives by q71 and q73.",
          "(6.9)",
          {start.q_wrist},
          start.list.items(),
          {{"h", channels, 1, h, "m", "without the fingers"}, {"P", channels, 2, P, "m/rad", ""}}};
}

}  // namespace sinew

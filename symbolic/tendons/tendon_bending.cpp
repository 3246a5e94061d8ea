// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/tendon_bending.h"

#include <stdexcept>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/kinematics.h"
#include "symbolic/expressions/piecewise.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/tendons/tendons.h"

namespace sinew {
namespace {

using GiNaC::ex;

std::size_t joint_named(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    if (mechanism.joints[i].name == name) return i;
  throw std::invalid_argument("no joint is called " + name);
}

ex dot(const Vector3ex& a, const Vector3ex& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3ex cross(const Vector3ex& a, const Vector3ex& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Angle of two directions: exact where they agree, as the arc cosine of their product is not.
ex angle_between(DefinitionList& list, const std::string& name, const Vector3ex& a,
                 const Vector3ex& b) {
  const Vector3ex aside = named(list, name + "_aside", cross(a, b));
  return GiNaC::atan2(sqrt(dot(aside, aside)), dot(a, b));
}

/// The stretch's direction seen from both of its bodies, at one pose.
struct Directions {
  Vector3ex from, to;
};

Directions directions(DefinitionList& list, Kinematics& kinematics, const Mechanism& mechanism,
                      const StraightRouting& s, const std::string& name) {
  const int from = body_named(mechanism, s.from_body), to = body_named(mechanism, s.to_body);
  const Vector3ex a = kinematics.point(name + "_from", from, s.from),
                  b = kinematics.point(name + "_to", to, s.to);
  const Vector3ex d = named(list, name + "_d", {b[0] - a[0], b[1] - a[1], b[2] - a[2]});
  const auto seen_from = [&](int body, const std::string& what) {
    const Matrix3ex R = kinematics.frame(name + what, body, Transform{}).R;
    return named(list, name + what + "_d",
                 {R[0][0] * d[0] + R[1][0] * d[1] + R[2][0] * d[2],
                  R[0][1] * d[0] + R[1][1] * d[1] + R[2][1] * d[2],
                  R[0][2] * d[0] + R[1][2] * d[1] + R[2][2] * d[2]});
  };
  return {seen_from(from, "_start"), seen_from(to, "_end")};
}

/// The same at q = 0, as numbers.
Directions directions_at_rest(const Mechanism& mechanism, const JointTree& tree,
                              const StraightRouting& s) {
  DefinitionList rest;
  const Coordinates coordinates(mechanism);
  const std::vector<ex> zero(static_cast<std::size_t>(coordinates.count()), 0);
  Kinematics kinematics(rest, tree, coordinates.at(rest, zero).positions());
  Directions d = directions(rest, kinematics, mechanism, s, "rest");
  GiNaC::exmap values;
  for (const Definition& item : rest.items()) values[item.symbol] = item.value.subs(values).evalf();
  for (Vector3ex* each : {&d.from, &d.to})
    for (ex& component : *each) component = component.subs(values).evalf();
  return d;
}

}  // namespace

Function tendon_bending_angles(const Mechanism& mechanism) {
  const Argument q = joint_positions(mechanism);
  DefinitionList list;
  const JointTree tree = build_joint_tree(mechanism);
  const std::vector<ex> joints =
      Coordinates(mechanism).at(list, {q.symbols.begin(), q.symbols.end()}).positions();
  const std::vector<int> moving = coordinate_of_joint(mechanism);
  Kinematics kinematics(list, tree, joints);
  std::vector<ex> angles;
  for (const Tendon& tendon : mechanism.tendons) {
    ex sum = 0;
    for (const PulleyRouting& pulley : tendon.pulleys) {
      const std::size_t joint = joint_named(mechanism, pulley.joint);
      if (moving[joint] >= 0 && mechanism.joints[joint].type == JointType::revolute)
        sum += magnitude(joints[static_cast<std::size_t>(moving[joint])]);
    }
    for (const StraightRouting& straight : tendon.straights) {
      const std::string name = tendon.name + "_stretch";
      const Directions now = directions(list, kinematics, mechanism, straight, name),
                       rest = directions_at_rest(mechanism, tree, straight);
      // Two statements: which of two summands comes first would be the compiler's to say.
      sum += angle_between(list, name + "_start", rest.from, now.from);
      sum += angle_between(list, name + "_end", rest.to, now.to);
    }
    angles.push_back(sum);
  }
  return {"bending_angles",
          "Total bending of each tendon in the finger: what guiding friction grows with.",
          "4.2",
          {q},
          list.items(),
          {{"angles", static_cast<int>(angles.size()), 1, angles, "rad",
            "over its pulleys, and where its straight stretches lean away from q = 0"}}};
}

}  // namespace sinew

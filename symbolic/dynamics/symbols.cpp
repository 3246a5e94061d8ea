// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/symbols.h"

#include <functional>

#include "symbolic/dynamics/coordinates.h"

namespace sinew {
namespace {

bool any_of_type(const Mechanism& mechanism, JointType type) {
  for (const Joint& joint : mechanism.joints)
    if (joint.type == type) return true;
  return false;
}

std::string by_type(const Mechanism& mechanism, const std::string& revolute,
                    const std::string& prismatic) {
  const bool turns = any_of_type(mechanism, JointType::revolute);
  const bool slides = any_of_type(mechanism, JointType::prismatic);
  if (turns && slides) return revolute + " | " + prismatic;
  return slides ? prismatic : revolute;
}

Argument per_coordinate(const Mechanism& mechanism, const std::string& name,
                        const std::string& unit, const std::string& doc,
                        const std::function<Range(const Joint&)>& range) {
  Argument argument{name, 0, 1, {}, unit, doc, {}};
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    argument.symbols.emplace_back(name + std::to_string(argument.rows++));
    argument.ranges.push_back(range(joint));
  }
  return argument;
}

}  // namespace

Argument make_argument(const std::string& name, int rows, int cols, const std::string& unit,
                       const std::string& doc, Range range) {
  Argument argument{name, rows, cols, {}, unit, doc, {}};
  for (int i = 0; i < rows * cols; ++i) {
    argument.symbols.emplace_back(name + std::to_string(i));
    argument.ranges.push_back(range);
  }
  return argument;
}

std::string coordinate_unit(const Mechanism& mechanism, const std::string& suffix) {
  return by_type(mechanism, "rad" + suffix, "m" + suffix);
}

std::string torque_unit(const Mechanism& mechanism) {
  return by_type(mechanism, "N m", "N");
}

Argument joint_positions(const Mechanism& mechanism) {
  Argument q = per_coordinate(mechanism, "q", coordinate_unit(mechanism, ""), "joint positions",
                              [](const Joint& j) {
                                return Range{j.low, j.high};
                              });
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    q.reference.push_back(joint.reference.value_or((joint.low + joint.high) / 2));
  }
  return q;
}

Argument joint_velocities(const Mechanism& mechanism) {
  return per_coordinate(mechanism, "qd", coordinate_unit(mechanism, "/s"), "joint velocities",
                        [](const Joint& j) {
                          return Range{-j.max_velocity, j.max_velocity};
                        });
}

Argument joint_accelerations(const Mechanism& mechanism) {
  return per_coordinate(mechanism, "qdd", coordinate_unit(mechanism, "/s^2"), "joint accelerations",
                        [](const Joint& j) {
                          return Range{-j.max_acceleration, j.max_acceleration};
                        });
}

Argument joint_torques(const Mechanism& mechanism) {
  return per_coordinate(mechanism, "tau", torque_unit(mechanism), "joint torques",
                        [](const Joint&) {
                          return Range{-1.0, 1.0};
                        });
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/mechanism.h"

#include <algorithm>

namespace sinew {

std::vector<int> coordinate_of_joint(const Mechanism& mechanism) {
  std::vector<int> coordinate;
  int next = 0;
  for (const Joint& joint : mechanism.joints)
    coordinate.push_back(joint.type == JointType::fixed ? -1 : next++);
  return coordinate;
}

int coordinate_count(const Mechanism& mechanism) {
  int count = 0;
  for (int index : coordinate_of_joint(mechanism)) count += index >= 0;
  return count;
}

bool is_massless(const Mechanism& mechanism) {
  return std::all_of(mechanism.bodies.begin(), mechanism.bodies.end(),
                     [](const Body& body) { return body.mass == 0.0; });
}

std::string why_no_dynamics(const Mechanism& mechanism) {
  return "no body of '" + mechanism.name +
         "' has a mass: it is a description of kinematics alone, and what needs masses (mass "
         "matrix, gravity, dynamics, simulation, diagnosis) cannot be had. To have it, give the "
         "bodies masses and inertias in mass_properties.csv and take out massless = true";
}

}  // namespace sinew

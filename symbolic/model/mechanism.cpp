// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/mechanism.h"

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

}  // namespace sinew

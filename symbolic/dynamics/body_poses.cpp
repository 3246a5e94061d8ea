// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/body_poses.h"

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/kinematics.h"
#include "symbolic/dynamics/symbols.h"

namespace sinew {

Function body_poses_function(const Mechanism& mechanism) {
  const Argument q = joint_positions(mechanism);
  DefinitionList list;
  const JointTree tree = build_joint_tree(mechanism);
  const Coordinates coordinates(mechanism);
  Kinematics kinematics(list, tree,
                        coordinates.at(list, {q.symbols.begin(), q.symbols.end()}).positions());
  std::vector<GiNaC::ex> T;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const PoseEx pose = kinematics.frame("body", static_cast<int>(i), Transform());
    for (std::size_t row = 0; row < 3; ++row) {
      T.insert(T.end(), pose.R[row].begin(), pose.R[row].end());
      T.push_back(pose.p[row]);
    }
  }
  return {"body_poses",
          "Poses of all bodies in the base frame, one below the other.",
          "(5.2)",
          {q},
          list.items(),
          {{"T", 3 * static_cast<int>(mechanism.bodies.size()), 4, T, "1 and m",
            "map the bodies' frames to the base"}}};
}

}  // namespace sinew

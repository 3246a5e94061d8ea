// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/functions.h"

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/dynamics_functions.h"
#include "symbolic/dynamics/kinematics.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/tendons/tendon_bending.h"
#include "symbolic/tendons/tendon_functions.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// The frame whose pose is offered: the first named one, else the last body's.
Frame tip_frame(const Mechanism& mechanism) {
  if (!mechanism.frames.empty()) return mechanism.frames.front();
  Frame frame;
  frame.name = frame.body = mechanism.bodies.back().name;
  return frame;
}

int body_index(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
    if (mechanism.bodies[i].name == name) return static_cast<int>(i);
  return -1;
}

std::vector<ex> homogeneous(const PoseEx& pose) {
  std::vector<ex> T;
  for (std::size_t i = 0; i < 3; ++i) {
    T.insert(T.end(), pose.R[i].begin(), pose.R[i].end());
    T.push_back(pose.p[i]);
  }
  T.insert(T.end(), {ex(0), ex(0), ex(0), ex(1)});
  return T;
}

}  // namespace

std::vector<Function> kinematics_functions(const Mechanism& mechanism) {
  const Argument q = joint_positions(mechanism);
  const Frame tip = tip_frame(mechanism);
  const int body = body_index(mechanism, tip.body);
  DefinitionList list;
  const JointTree tree = build_joint_tree(mechanism);
  const Coordinates coordinates(mechanism);
  const JointMap joints = coordinates.at(list, {q.symbols.begin(), q.symbols.end()});
  Kinematics kinematics(list, tree, joints.positions());
  const PoseEx pose = kinematics.frame("tip", body, tip.pose);
  const std::vector<Definition> for_pose = list.items();
  const std::vector<ex> J = joints.projected_columns(kinematics.jacobian(body, pose.p));
  return {{"forward_kinematics",
           "Pose of the frame " + tip.name + " in the base frame, homogeneous.",
           "(5.2)",
           {q},
           for_pose,
           {{"T", 4, 4, homogeneous(pose), "m", "maps coordinates of the frame to the base"}}},
          {"tip_jacobian",
           "Geometric Jacobian of the frame " + tip.name + ": linear rows first, base frame.",
           "",
           {q},
           list.items(),
           {{"J", 6, q.rows, J, "m | 1", "velocity and angular velocity a joint rate"}}}};
}

std::vector<Function> functions_of(const Mechanism& mechanism, const CostOf& cost,
                                   bool runtime_parameters) {
  std::vector<Function> all = kinematics_functions(mechanism);
  for (const Function& f : dynamics_functions(mechanism, cost, runtime_parameters))
    all.push_back(f);
  for (const Function& f : tendon_functions(mechanism)) all.push_back(f);
  if (!mechanism.tendons.empty()) all.push_back(tendon_bending_angles(mechanism));
  return all;
}

}  // namespace sinew

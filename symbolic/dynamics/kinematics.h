// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/dynamics/dynamics_plan.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/runs.h"
#include "symbolic/dynamics/spatial.h"

namespace sinew {

/// Pose in the base frame, or in that of what carries it.
struct PoseEx {
  Matrix3ex R;
  Vector3ex p;
};

/// Of a homogeneous transform, 4 x 4, row by row.
PoseEx from_homogeneous(const std::vector<GiNaC::ex>& T);
PoseEx from_transform(const Transform& transform);

/// Poses of all links, and their joints' axes, in the base frame.
class Kinematics {
 public:
  Kinematics(DefinitionList& list, const JointTree& tree, const std::vector<GiNaC::ex>& q);

  /// Pose of a frame fixed to a body of the mechanism (body -1: base).
  PoseEx frame(const std::string& name, int body, const Transform& pose_in_body);

  /// Position of a point fixed to a body, m.
  Vector3ex point(const std::string& name, int body, const Eigen::Vector3d& in_body);

  /// 6 x n, row-major, linear rows first: velocity of a point of `body` at `position` and angular
  /// velocity, base frame.
  std::vector<GiNaC::ex> jacobian(int body, const Vector3ex& position);

 private:
  void place_run(const Run& run, const std::vector<CosSin>& angles,
                 const std::vector<GiNaC::ex>& q);
  PoseEx fixed(const std::string& name, const PoseEx& carrier, const NumberMatrix3& R,
               const NumberVector3& p);

  DefinitionList& list_;
  const JointTree& tree_;
  std::vector<PoseEx> links_;
  std::vector<Vector3ex> axes_;
};

}  // namespace sinew

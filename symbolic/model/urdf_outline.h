// SPDX-License-Identifier: GPL-3.0-or-later
// What urdfdom does not tell of a URDF file: where elements stand and in which order, the angles as
// written, and every mistake with its line and column.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/files/description_error.h"
#include "symbolic/model/order_bodies.h"

namespace sinew {

struct UrdfLink {
  std::string name;
  SourceLocation where;
  SourceLocation mass_where;
  SourceLocation inertia_where;
  bool has_inertial = false;
  Eigen::Vector3d inertial_rpy = Eigen::Vector3d::Zero();  ///< rad; urdfdom keeps a quaternion only
};

struct UrdfJoint {
  std::string name;
  std::string type;
  TreeJoint ends;
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();  ///< rad
  bool has_range = false;                         ///< lower and upper limits are given
  bool has_velocity = false;                      ///< a velocity limit above zero is given
  SourceLocation limit_where;
  std::string mimics;  ///< name of the joint it follows, or ""
  SourceLocation mimic_where;
};

struct UrdfOutline {
  std::string robot;
  SourceLocation robot_where;
  std::string root;  ///< name of the root link: the base
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;
  std::string essence;  ///< the document reduced to what urdfdom has to read
};

/// Reads a URDF document. Mistakes go to `findings` (then the outline is incomplete), what is
/// ignored or assumed to `notes`.
UrdfOutline outline_urdf(std::string_view text, const std::string& file, Findings& findings,
                         std::vector<std::string>& notes);

}  // namespace sinew

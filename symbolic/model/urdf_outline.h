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
  bool has_shape = false;  ///< a <visual> or <collision>: something that would have mass
  Eigen::Vector3d inertial_rpy = Eigen::Vector3d::Zero();  ///< rad; urdfdom keeps a quaternion only
};

struct UrdfJoint {
  std::string name;
  std::string type;
  TreeJoint ends;
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();  ///< rad
  bool has_range = false;                         ///< limits with more than one value are given
  double low = 0.0, high = 0.0;                   ///< rad or m, where has_range
  std::optional<double> held;                     ///< rad or m: the joint stands still there
  bool has_velocity = false;                      ///< a velocity limit above zero is given
  SourceLocation limit_where;
  std::string
      mimics;  ///< name of the joint it follows, or ""; position = multiplier * that one's + offset
  double multiplier = 1.0;
  double offset = 0.0;  ///< rad or m
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

/// What is told of a description besides mistakes.
struct UrdfRemarks {
  std::vector<std::string>& notes;     ///< ignored, assumed, renamed
  std::vector<std::string>& warnings;  ///< the mechanism is another one than the file's
};

/// Reads a URDF document. Mistakes go to `findings` (then the outline is incomplete). Joints that
/// follow others do so in one step (urdf_mimics.h).
UrdfOutline outline_urdf(std::string_view text, const std::string& file, Findings& findings,
                         const UrdfRemarks& remarks);

}  // namespace sinew

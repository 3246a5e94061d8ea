// SPDX-License-Identifier: GPL-3.0-or-later
// Where a force may act that no log has, and what it asks of the joints.
#pragma once

#include <string>
#include <vector>

#include "identification/contacts/disturbances.h"
#include "identification/subjects/rigid_candidates.h"

namespace sinew::diagnosis {

/// One place. A force at a link has any direction and acts at a point; anywhere else it is one
/// number: a torque or a force at a joint, an error of a tendon's force.
struct ForcePlace {
  std::string name;  ///< "joint elbow", "link forearm", "tendon h5"
  std::string unit;  ///< of what acts
  bool at_link = false;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< where its point is expected, link's frame
  double size = 0.0;                                 ///< m: how far from there it may well be
  /// Per disturbance, what 1 N or 1 N m asks of the channels. Elsewhere samples x channels. At a
  /// link samples x (12 channels): columns of x, y and z of the base's frame for a force at the
  /// link's origin, then for one 1 m along the link's own x, y and z.
  std::vector<Eigen::MatrixXd> effort;
};

/// At every channel.
std::vector<ForcePlace> channel_places(const Disturbances& disturbances,
                                       const std::vector<std::string>& names,
                                       const std::vector<std::string>& units);

/// At every link that moves.
std::vector<ForcePlace> link_places(const Disturbances& disturbances, const RigidColumns& rigid);

}  // namespace sinew::diagnosis

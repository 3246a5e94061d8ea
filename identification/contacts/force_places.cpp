// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/contacts/force_places.h"

#include <tuple>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// The joints' positions in a disturbance, as a recording of its own.
Recording held_positions(const LeftOver& r, const Disturbance& d) {
  Recording log;
  log.q = r.position.middleRows(d.first, d.last - d.first);
  log.qd = log.qdd = MatrixXd::Zero(log.q.rows(), log.q.cols());
  return log;
}

/// What forces at a point ask of all channels; those that are no coordinate of the mechanism, a
/// motor's, feel nothing of it.
MatrixXd at_all_channels(const MatrixXd& of_joints, Index joints, Index channels) {
  MatrixXd effort = MatrixXd::Zero(of_joints.rows(), 3 * channels);
  for (Index axis = 0; axis < 3; ++axis)
    effort.middleCols(axis * channels, joints) = of_joints.middleCols(axis * joints, joints);
  return effort;
}

}  // namespace

std::vector<ForcePlace> channel_places(const Disturbances& disturbances,
                                       const std::vector<std::string>& names,
                                       const std::vector<std::string>& units) {
  std::vector<ForcePlace> places;
  for (std::size_t c = 0; c < names.size(); ++c) {
    ForcePlace place;
    place.name = names[c];
    place.unit = units[c];
    for (const Disturbance& d : disturbances.list) {
      MatrixXd effort = MatrixXd::Zero(d.last - d.first, static_cast<Index>(names.size()));
      effort.col(static_cast<Index>(c)).setConstant(-1.0);  // what pushes needs not be asked for
      place.effort.push_back(std::move(effort));
    }
    places.push_back(std::move(place));
  }
  return places;
}

std::vector<ForcePlace> link_places(const Disturbances& disturbances, const RigidColumns& rigid) {
  std::vector<ForcePlace> places;
  const Index joints = rigid.coordinates();
  for (const std::string& link : rigid.moving_links()) {
    ForcePlace place;
    place.name = "link " + link;
    place.unit = "N";
    place.at_link = true;
    std::tie(place.centre, place.size) = rigid.extent_of(link);
    for (const Disturbance& d : disturbances.list) {
      const LeftOver& r = disturbances.left_over[d.recording];
      const Recording log = held_positions(r, d);
      MatrixXd effort(log.q.rows(), 12 * r.residual.cols());
      for (Index point = 0; point < 4; ++point) {
        const Vector3d at = point == 0 ? Vector3d(Vector3d::Zero()) : Vector3d::Unit(point - 1);
        effort.middleCols(3 * r.residual.cols() * point, 3 * r.residual.cols()) =
            at_all_channels(rigid.force_columns(link, at, log), joints, r.residual.cols());
      }
      place.effort.push_back(std::move(effort));
    }
    places.push_back(std::move(place));
  }
  return places;
}

}  // namespace sinew::diagnosis

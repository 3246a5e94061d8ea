// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/coordinates.h"

#include <fmt/format.h>

#include <stdexcept>

#include "symbolic/exact_number.h"

namespace sinew {
namespace {

using GiNaC::ex;

const JointCoupling* coupling_of(const Mechanism& mechanism, const std::string& joint) {
  for (const JointCoupling& coupling : mechanism.couplings)
    if (coupling.dependent == joint) return &coupling;
  return nullptr;
}

}  // namespace

Coordinates::Coordinates(const Mechanism& mechanism) {
  std::vector<int> coordinate(mechanism.joints.size(), -1);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.type == JointType::fixed || coupling_of(mechanism, joint.name)) continue;
    coordinate[i] = count();
    joints_.push_back(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    if (mechanism.joints[i].type == JointType::fixed) continue;
    const JointCoupling* coupling = coupling_of(mechanism, mechanism.joints[i].name);
    if (!coupling) {
      moving_.push_back({coordinate[i], ex(1)});
      continue;
    }
    int independent = -1;
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j)
      if (mechanism.joints[j].name == coupling->independent) independent = coordinate[j];
    if (independent < 0)
      throw std::invalid_argument(fmt::format("coupling of {}: {} is no independent moving joint",
                                              coupling->dependent, coupling->independent));
    moving_.push_back({independent, exact_number(coupling->ratio)});
  }
}

std::vector<ex> Coordinates::of_moving_joints(const std::vector<ex>& coordinates) const {
  std::vector<ex> values;
  for (const Follows& joint : moving_)
    values.push_back(joint.ratio * coordinates[static_cast<std::size_t>(joint.coordinate)]);
  return values;
}

std::vector<ex> Coordinates::projected(const std::vector<ex>& joint_forces) const {
  std::vector<ex> forces(joints_.size(), ex(0));
  for (std::size_t j = 0; j < moving_.size(); ++j)
    forces[static_cast<std::size_t>(moving_[j].coordinate)] += moving_[j].ratio * joint_forces[j];
  return forces;
}

std::vector<ex> Coordinates::projected_columns(const std::vector<ex>& matrix) const {
  const std::size_t m = moving_.size(), n = joints_.size(), rows = matrix.size() / m;
  std::vector<ex> result(rows * n, ex(0));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < m; ++j)
      result[i * n + static_cast<std::size_t>(moving_[j].coordinate)] +=
          moving_[j].ratio * matrix[i * m + j];
  return result;
}

std::vector<ex> Coordinates::projected_matrix(const std::vector<ex>& joint_matrix) const {
  const std::size_t m = moving_.size(), n = joints_.size();
  const std::vector<ex> columns = projected_columns(joint_matrix);
  std::vector<ex> result(n * n, ex(0));
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      result[static_cast<std::size_t>(moving_[i].coordinate) * n + j] +=
          moving_[i].ratio * columns[i * n + j];
  return result;
}

}  // namespace sinew

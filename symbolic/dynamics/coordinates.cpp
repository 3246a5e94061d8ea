// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/coordinates.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "symbolic/expressions/exact_number.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/parts/four_bar.h"

namespace sinew {
namespace {

using GiNaC::ex;

template <class Coupling>
const Coupling* coupling_of(const std::vector<Coupling>& couplings, const std::string& joint) {
  for (const Coupling& coupling : couplings)
    if (coupling.dependent == joint) return &coupling;
  return nullptr;
}

bool is_dependent(const Mechanism& mechanism, const std::string& joint) {
  return coupling_of(mechanism.couplings, joint) || coupling_of(mechanism.four_bars, joint);
}

Function linkage_of(const FourBarCoupling& coupling) {
  FourBarParameters p;
  p.ground = coupling.ground;
  p.crank = coupling.crank;
  p.coupler = coupling.coupler;
  p.rocker = coupling.rocker;
  p.branch = coupling.branch;
  p.reference_theta2 = coupling.crank_angle;
  return four_bar_joint(p, coupling.follows == FourBarCoupling::Follows::rocker
                               ? FourBarAngle::rocker
                               : FourBarAngle::coupler_on_crank);
}

}  // namespace

std::vector<ex> JointMap::positions() const {
  std::vector<ex> values;
  for (const Entry& joint : joints_) values.push_back(joint.position);
  return values;
}

std::vector<ex> JointMap::velocities(const std::vector<ex>& qd) const {
  std::vector<ex> values;
  for (const Entry& joint : joints_)
    values.push_back(joint.slope * qd[static_cast<std::size_t>(joint.coordinate)]);
  return values;
}

std::vector<ex> JointMap::accelerations(DefinitionList& list, const std::vector<ex>& qd,
                                        const std::vector<ex>& qdd) const {
  std::vector<ex> values;
  for (const Entry& joint : joints_) {
    const auto k = static_cast<std::size_t>(joint.coordinate);
    const ex bend = joint.curvature.is_zero() ? ex(0) : joint.curvature * qd[k] * qd[k];
    const ex value = joint.slope * qdd[k] + bend;
    values.push_back(bend.is_zero() ? value : list.define("linkage_acceleration", value));
  }
  return values;
}

std::vector<ex> JointMap::projected(const std::vector<ex>& joint_forces) const {
  std::vector<ex> forces(coordinates_, ex(0));
  for (std::size_t j = 0; j < joints_.size(); ++j)
    forces[static_cast<std::size_t>(joints_[j].coordinate)] += joints_[j].slope * joint_forces[j];
  return forces;
}

std::vector<ex> JointMap::projected_columns(const std::vector<ex>& matrix) const {
  const std::size_t m = joints_.size(), n = coordinates_, rows = matrix.size() / m;
  std::vector<ex> result(rows * n, ex(0));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < m; ++j)
      result[i * n + static_cast<std::size_t>(joints_[j].coordinate)] +=
          joints_[j].slope * matrix[i * m + j];
  return result;
}

std::vector<ex> JointMap::projected_matrix(const std::vector<ex>& joint_matrix) const {
  return projected_rows(projected_columns(joint_matrix));
}

std::vector<ex> JointMap::projected_coriolis(const std::vector<ex>& C, const std::vector<ex>& M,
                                             const std::vector<ex>& qd) const {
  const std::size_t m = joints_.size(), n = coordinates_;
  std::vector<ex> columns = projected_columns(C);
  for (std::size_t j = 0; j < m; ++j) {
    if (joints_[j].curvature.is_zero()) continue;
    const auto k = static_cast<std::size_t>(joints_[j].coordinate);
    for (std::size_t i = 0; i < m; ++i)
      columns[i * n + k] += M[i * m + j] * joints_[j].curvature * qd[k];
  }
  return projected_rows(columns);
}

std::vector<ex> JointMap::projected_rows(const std::vector<ex>& columns) const {
  const std::size_t m = joints_.size(), n = coordinates_;
  std::vector<ex> result(n * n, ex(0));
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
      result[static_cast<std::size_t>(joints_[i].coordinate) * n + j] +=
          joints_[i].slope * columns[i * n + j];
  return result;
}

Coordinates::Coordinates(const Mechanism& mechanism) {
  std::vector<int> coordinate(mechanism.joints.size(), -1);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.type == JointType::fixed || is_dependent(mechanism, joint.name)) continue;
    coordinate[i] = count();
    joints_.push_back(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.type == JointType::fixed) continue;
    if (const auto* loop = coupling_of(mechanism.couplings, joint.name))
      moving_.push_back({coordinate_of(mechanism, coordinate, loop->dependent, loop->independent),
                         exact_number(loop->ratio), exact_number(loop->offset), nullptr, 0});
    else if (const auto* bars = coupling_of(mechanism.four_bars, joint.name))
      moving_.push_back({coordinate_of(mechanism, coordinate, bars->dependent, bars->independent),
                         0, 0, std::make_shared<const Function>(linkage_of(*bars)),
                         exact_number(bars->crank_angle)});
    else
      moving_.push_back({coordinate[i], ex(1), ex(0), nullptr, 0});
  }
}

int Coordinates::coordinate_of(const Mechanism& mechanism, const std::vector<int>& coordinate,
                               const std::string& dependent, const std::string& independent) const {
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j)
    if (mechanism.joints[j].name == independent && coordinate[j] >= 0) return coordinate[j];
  throw std::invalid_argument(
      fmt::format("coupling of {}: {} is no independent moving joint", dependent, independent));
}

bool Coordinates::linear() const {
  return std::none_of(moving_.begin(), moving_.end(),
                      [](const Follows& joint) { return joint.linkage != nullptr; });
}

JointMap Coordinates::at(DefinitionList& list, const std::vector<ex>& q) const {
  std::vector<JointMap::Entry> joints;
  for (const Follows& joint : moving_) {
    const ex& own = q[static_cast<std::size_t>(joint.coordinate)];
    if (!joint.linkage) {
      joints.push_back({joint.coordinate, joint.ratio * own + joint.offset, joint.ratio, ex(0)});
      continue;
    }
    const ex theta2 = list.define("theta2", own + joint.crank_angle);
    const auto values = inlined(list, *joint.linkage, {theta2});
    joints.push_back({joint.coordinate, list.define("linked", values[0][0]), values[1][0],
                      list.define("linkage_curvature", values[2][0])});
  }
  return {std::move(joints), joints_.size()};
}

}  // namespace sinew

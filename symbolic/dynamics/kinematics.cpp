// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/kinematics.h"

#include "symbolic/expressions/exact_number.h"
#include "symbolic/dynamics/joint_angles.h"
#include "symbolic/dynamics/run_geometry.h"

namespace sinew {
namespace {

using GiNaC::ex;

PoseEx base_pose() {
  PoseEx pose{zero_matrix(), zero_vector()};
  for (std::size_t i = 0; i < 3; ++i) pose.R[i][i] = 1;
  return pose;
}

Vector3ex column(const Matrix3ex& R, std::size_t j) {
  return {R[0][j], R[1][j], R[2][j]};
}

}  // namespace

PoseEx from_homogeneous(const std::vector<GiNaC::ex>& T) {
  PoseEx pose;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) pose.R[i][j] = T[4 * i + j];
    pose.p[i] = T[4 * i + 3];
  }
  return pose;
}

PoseEx from_transform(const Transform& transform) {
  PoseEx pose;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t j = 0; j < 3; ++j)
      pose.R[i][j] = exact_number(transform.rotation(row, static_cast<Eigen::Index>(j)));
    pose.p[i] = exact_number(transform.translation[row]);
  }
  return pose;
}

Kinematics::Kinematics(DefinitionList& list, const JointTree& tree, const std::vector<ex>& q)
    : list_(list), tree_(tree), links_(tree.links.size()), axes_(tree.links.size()) {
  const Runs runs = split_into_runs(tree, {});
  const std::vector<CosSin> angles = joint_angles(list, tree, runs, q);
  for (const Run& run : runs.runs) place_run(run, angles, q);
}

PoseEx Kinematics::fixed(const std::string& name, const PoseEx& carrier, const NumberMatrix3& R,
                         const NumberVector3& p) {
  PoseEx pose;
  const Vector3ex offset = times(carrier.R, to_expression(p));
  pose.p = named(list_, "p" + name, carrier.p + offset);
  for (std::size_t i = 0; i < 3; ++i)
    pose.R[i] = named(list_, "R" + name + std::to_string(i + 1), transpose_times(R, carrier.R[i]));
  return pose;
}

void Kinematics::place_run(const Run& run, const std::vector<CosSin>& angles,
                           const std::vector<ex>& q) {
  const TreeLink& first = tree_.links[static_cast<std::size_t>(run.links[0])];
  const PoseEx carrier =
      first.parent < 0 ? base_pose() : links_[static_cast<std::size_t>(first.parent)];
  const PoseEx base = fixed(std::to_string(run.links[0] + 1), carrier, first.R, first.p);
  std::vector<PseudoInertia> massless(run.links.size());
  const std::vector<RunLink> geometry = run_geometry(list_, tree_, run, angles, massless);
  for (const RunLink& at : geometry) {
    const auto i = static_cast<std::size_t>(at.link);
    const std::string name = std::to_string(at.link + 1);
    Vector3ex offset{at.o[0], at.o[1], ex(0)};
    if (tree_.links[i].type == JointType::prismatic)
      offset[2] += q[static_cast<std::size_t>(tree_.links[i].coordinate)];
    PoseEx& pose = links_[i];
    pose.p = named(list_, "p" + name, base.p + times(base.R, offset));
    for (std::size_t row = 0; row < 3; ++row)
      pose.R[row] =
          named(list_, "R" + name + std::to_string(row + 1), turn_back(at.angle, base.R[row]));
    axes_[i] = column(base.R, 2);
  }
}

PoseEx Kinematics::frame(const std::string& name, int body, const Transform& in_body) {
  const NumberMatrix3 R = in_body.rotation.cast<Number>();
  const NumberVector3 p = in_body.translation.cast<Number>();
  if (body < 0) return fixed(name, base_pose(), R, p);
  const BodyPlace& place = tree_.bodies[static_cast<std::size_t>(body)];
  const PoseEx carrier =
      place.link < 0 ? base_pose() : links_[static_cast<std::size_t>(place.link)];
  return fixed(name, carrier, place.R * R, place.R * p + place.p);
}

Vector3ex Kinematics::point(const std::string& name, int body, const Eigen::Vector3d& in_body) {
  Transform pose;
  pose.translation = in_body;
  return frame(name, body, pose).p;
}

std::vector<ex> Kinematics::jacobian(int body, const Vector3ex& position) {
  const std::size_t n = tree_.links.size();
  std::vector<ex> J(6 * n, ex(0));
  int i = body < 0 ? -1 : tree_.bodies[static_cast<std::size_t>(body)].link;
  for (; i >= 0; i = tree_.links[static_cast<std::size_t>(i)].parent) {
    const TreeLink& link = tree_.links[static_cast<std::size_t>(i)];
    const Vector3ex& z = axes_[static_cast<std::size_t>(i)];
    const bool slides = link.type == JointType::prismatic;
    Vector3ex arm;
    for (std::size_t k = 0; k < 3; ++k)
      arm[k] = named(list_, "arm" + std::to_string(i + 1),
                     position[k] - links_[static_cast<std::size_t>(i)].p[k]);
    const Vector3ex linear = slides ? z : cross(z, arm);
    const auto c = static_cast<std::size_t>(link.coordinate);
    for (std::size_t k = 0; k < 3; ++k) {
      J[k * n + c] = link.sign * linear[k];
      if (!slides) J[(k + 3) * n + c] = link.sign * z[k];
    }
  }
  return J;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/urdf_truth.h"

#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <stdexcept>

namespace sinew {
namespace {

Eigen::Isometry3d transform(const urdf::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() =
      Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z)
          .toRotationMatrix();
  result.translation() << pose.position.x, pose.position.y, pose.position.z;
  return result;
}

}  // namespace

UrdfTruth::UrdfTruth(const std::filesystem::path& file, std::vector<std::string> coordinates)
    : model_(urdf::parseURDFFile(file.string())), coordinates_(std::move(coordinates)) {
  if (!model_) throw std::runtime_error("urdfdom refuses " + file.string());
}

double UrdfTruth::position(const urdf::Joint& joint, const Eigen::VectorXd& q) const {
  if (joint.mimic)
    return joint.mimic->multiplier * position(*model_->getJoint(joint.mimic->joint_name), q) +
           joint.mimic->offset;
  const auto own = std::find(coordinates_.begin(), coordinates_.end(), joint.name);
  if (own != coordinates_.end()) return q[own - coordinates_.begin()];
  return joint.limits ? joint.limits->lower : 0.0;  // a range of one value
}

Eigen::Isometry3d UrdfTruth::pose(const std::string& link, const Eigen::VectorXd& q) const {
  const auto joint = model_->getLink(link)->parent_joint;
  if (!joint) return Eigen::Isometry3d::Identity();
  Eigen::Isometry3d result =
      pose(joint->parent_link_name, q) * transform(joint->parent_to_joint_origin_transform);
  const Eigen::Vector3d axis(joint->axis.x, joint->axis.y, joint->axis.z);
  if (joint->type == urdf::Joint::REVOLUTE || joint->type == urdf::Joint::CONTINUOUS)
    result.rotate(Eigen::AngleAxisd(position(*joint, q), axis.normalized()));
  if (joint->type == urdf::Joint::PRISMATIC)
    result.translate(axis.normalized() * position(*joint, q));
  return result;
}

Eigen::Isometry3d UrdfTruth::centre(const std::string& link, const Eigen::VectorXd& q) const {
  return pose(link, q) * transform(model_->getLink(link)->inertial->origin);
}

Eigen::MatrixXd UrdfTruth::jacobian(const std::string& link, const Eigen::VectorXd& q) const {
  constexpr double step = 1e-5;
  Eigen::MatrixXd J(6, q.size());
  const Eigen::Matrix3d R = centre(link, q).linear();
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const Eigen::VectorXd by = step * Eigen::VectorXd::Unit(q.size(), k);
    const Eigen::Isometry3d after = centre(link, q + by), before = centre(link, q - by);
    const Eigen::Matrix3d W = (after.linear() - before.linear()) * R.transpose() / (2 * step);
    J.col(k).head<3>() = (after.translation() - before.translation()) / (2 * step);
    J.col(k).tail<3>() << W(2, 1), W(0, 2), W(1, 0);
  }
  return J;
}

Eigen::MatrixXd UrdfTruth::mass_matrix(const Eigen::VectorXd& q) const {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(q.size(), q.size());
  for (const auto& [name, link] : model_->links_) {
    if (!link->inertial) continue;
    const urdf::Inertial& i = *link->inertial;
    Eigen::Matrix3d own;
    own << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
    const Eigen::Matrix3d R = centre(name, q).linear();
    const Eigen::MatrixXd J = jacobian(name, q);
    M += i.mass * J.topRows(3).transpose() * J.topRows(3) +
         J.bottomRows(3).transpose() * (R * own * R.transpose()) * J.bottomRows(3);
  }
  return M;
}

Eigen::VectorXd UrdfTruth::gravity(const Eigen::VectorXd& q,
                                   const Eigen::Vector3d& direction) const {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(q.size());
  for (const auto& [name, link] : model_->links_)
    if (link->inertial)
      g -= link->inertial->mass * jacobian(name, q).topRows(3).transpose() * direction;
  return g;
}

}  // namespace sinew

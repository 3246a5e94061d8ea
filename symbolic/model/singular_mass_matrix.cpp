// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/model/singular_mass_matrix.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <string>

namespace sinew {
namespace {

Transform motion(const Joint& joint, double q) {
  Transform moved;
  if (joint.type == JointType::revolute)
    moved.rotation = Eigen::AngleAxisd(q, joint.axis).toRotationMatrix();
  else if (joint.type == JointType::prismatic)
    moved.translation = q * joint.axis;
  return moved;
}

Transform operator*(const Transform& a, const Transform& b) {
  return {a.rotation * b.rotation, a.rotation * b.translation + a.translation};
}

/// Velocity of a body's centre of mass (rows 0-2) and its angular velocity (3-5) per coordinate.
Eigen::MatrixXd body_jacobian(const Mechanism& mechanism, const std::vector<Transform>& pose,
                              const std::vector<int>& coordinate, std::size_t body) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, coordinate_count(mechanism));
  const Transform& own = pose[body];
  const Eigen::Vector3d centre =
      own.rotation * mechanism.bodies[body].centre_of_mass + own.translation;
  for (int i = static_cast<int>(body); i >= 0;
       i = mechanism.joints[static_cast<std::size_t>(i)].parent) {
    const auto k = static_cast<std::size_t>(i);
    const Joint& joint = mechanism.joints[k];
    if (joint.type == JointType::fixed) continue;
    const Eigen::Vector3d axis = pose[k].rotation * joint.axis;
    if (joint.type == JointType::revolute) {
      jacobian.block<3, 1>(0, coordinate[k]) = axis.cross(centre - pose[k].translation);
      jacobian.block<3, 1>(3, coordinate[k]) = axis;
    } else {
      jacobian.block<3, 1>(0, coordinate[k]) = axis;
    }
  }
  return jacobian;
}

/// Index of the largest part of the null vector of a singular symmetric matrix; -1 if regular.
/// `most`: what its diagonal would be if all that each coordinate carries turned about it at its
/// distance. Less than a rounding error of that is nothing.
int null_coordinate(const Eigen::MatrixXd& mass, const Eigen::VectorXd& most) {
  constexpr double rounding_of_sums = 1e-13;
  Eigen::VectorXd scale = mass.diagonal();
  for (int i = 0; i < scale.size(); ++i) {
    if (scale[i] <= rounding_of_sums * most[i]) return i;
    scale[i] = 1.0 / std::sqrt(scale[i]);
  }
  const Eigen::MatrixXd unit = scale.asDiagonal() * mass * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(unit);
  if (solver.eigenvalues()[0] >= 1e-13) return -1;
  Eigen::Index largest = 0;
  solver.eigenvectors().col(0).cwiseAbs().maxCoeff(&largest);
  return static_cast<int>(largest);
}

}  // namespace

namespace {

/// Of every body in the base frame.
std::vector<Transform> body_poses(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  const std::vector<int> coordinate = coordinate_of_joint(mechanism);
  std::vector<Transform> pose;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const Transform parent =
        joint.parent < 0 ? Transform{} : pose[static_cast<std::size_t>(joint.parent)];
    const double value = coordinate[i] < 0 ? 0.0 : q[coordinate[i]];
    pose.push_back(parent * joint.origin * motion(joint, value));
  }
  return pose;
}

/// An upper bound of the mass matrix's diagonal: whatever axis the joints had.
Eigen::VectorXd most_inertia(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  const std::vector<int> coordinate = coordinate_of_joint(mechanism);
  const std::vector<Transform> pose = body_poses(mechanism, q);
  Eigen::VectorXd most = Eigen::VectorXd::Zero(q.size());
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    const Eigen::Vector3d centre = pose[b].rotation * body.centre_of_mass + pose[b].translation;
    for (int i = static_cast<int>(b); i >= 0;
         i = mechanism.joints[static_cast<std::size_t>(i)].parent) {
      const auto k = static_cast<std::size_t>(i);
      if (coordinate[k] < 0) continue;
      const bool turns = mechanism.joints[k].type == JointType::revolute;
      most[coordinate[k]] +=
          turns ? body.inertia.norm() + body.mass * (centre - pose[k].translation).squaredNorm()
                : body.mass;
    }
  }
  return most;
}

}  // namespace

Eigen::MatrixXd mass_matrix_at(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  const std::vector<int> coordinate = coordinate_of_joint(mechanism);
  const std::vector<Transform> pose = body_poses(mechanism, q);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(q.size(), q.size());
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    if (body.mass == 0.0 && body.inertia.isZero(0.0)) continue;
    const Eigen::MatrixXd j = body_jacobian(mechanism, pose, coordinate, i);
    const Eigen::Matrix3d inertia = pose[i].rotation * body.inertia * pose[i].rotation.transpose();
    mass += body.mass * j.topRows<3>().transpose() * j.topRows<3>() +
            j.bottomRows<3>().transpose() * inertia * j.bottomRows<3>();
  }
  return mass;
}

namespace {

/// The moving joints that have a coordinate of their own, and how all moving joints go with them. A
/// four-bar's joint moves by any share: whether it carries inertia does not depend on it.
struct CoordinateMap {
  std::vector<std::size_t> joints;
  Eigen::MatrixXd J;
};

CoordinateMap coordinate_map_of(const Mechanism& mechanism) {
  std::map<std::string, std::pair<std::string, double>> follows;
  for (const JointCoupling& each : mechanism.couplings)
    follows[each.dependent] = {each.independent, each.ratio};
  for (const FourBarCoupling& each : mechanism.four_bars)
    follows[each.dependent] = {each.independent, 0.7236};
  CoordinateMap motion;
  std::map<std::string, Eigen::Index> column;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.type == JointType::fixed || follows.count(joint.name)) continue;
    column[joint.name] = static_cast<Eigen::Index>(motion.joints.size());
    motion.joints.push_back(i);
  }
  motion.J.setZero(coordinate_count(mechanism), static_cast<Eigen::Index>(motion.joints.size()));
  Eigen::Index row = 0;
  for (const Joint& joint : mechanism.joints) {
    if (joint.type == JointType::fixed) continue;
    const auto dependent = follows.find(joint.name);
    const std::string& own = dependent == follows.end() ? joint.name : dependent->second.first;
    if (const auto found = column.find(own); found != column.end())
      motion.J(row, found->second) = dependent == follows.end() ? 1.0 : dependent->second.second;
    ++row;
  }
  return motion;
}

}  // namespace

std::optional<std::size_t> joint_without_inertia(const Mechanism& mechanism) {
  const std::vector<int> coordinate = coordinate_of_joint(mechanism);
  const int count = coordinate_count(mechanism);
  const CoordinateMap motion = coordinate_map_of(mechanism);
  if (count == 0 || motion.joints.empty()) return std::nullopt;
  int null = -1;
  for (int sample = 0; sample < 4; ++sample) {
    Eigen::VectorXd q(count);
    for (std::size_t i = 0; i < coordinate.size(); ++i) {
      if (coordinate[i] < 0) continue;
      const Joint& joint = mechanism.joints[i];
      const double part = std::fmod(0.31 + 0.618033988749895 * (4 * coordinate[i] + sample), 1.0);
      q[coordinate[i]] = joint.low + part * (joint.high - joint.low);
    }
    null = null_coordinate(motion.J.transpose() * mass_matrix_at(mechanism, q) * motion.J,
                           motion.J.cwiseAbs2().transpose() * most_inertia(mechanism, q));
    if (null < 0) return std::nullopt;
  }
  return motion.joints[static_cast<std::size_t>(null)];
}

std::optional<std::string> note_of_singular_mass_matrix(const Mechanism& mechanism) {
  const auto index = joint_without_inertia(mechanism);
  if (!index) return std::nullopt;
  const Joint& joint = mechanism.joints[*index];
  return fmt::format(
      "the mass matrix is singular: joint '{}' can move without moving any inertia. "
      "forward_dynamics, which needs its inverse, is left out; to have it, give the bodies that "
      "the joint carries {}",
      joint.name,
      joint.type == JointType::revolute ? "inertia about its axis, or mass off it" : "mass");
}

}  // namespace sinew

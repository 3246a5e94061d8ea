// SPDX-License-Identifier: GPL-3.0-or-later
// What a URDF file says, by urdfdom and differences: knows nothing of how this project reads and
// derives. Positions of mimic joints are followed from joint to joint.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace urdf {
class ModelInterface;
class Joint;
}  // namespace urdf

namespace sinew {

class UrdfTruth {
 public:
  /// `coordinates`: names of the joints that move by themselves, in their order.
  UrdfTruth(const std::filesystem::path& file, std::vector<std::string> coordinates);

  Eigen::Isometry3d pose(const std::string& link, const Eigen::VectorXd& q) const;
  /// By central differences, to about 1e-9.
  Eigen::MatrixXd mass_matrix(const Eigen::VectorXd& q) const;
  Eigen::VectorXd gravity(const Eigen::VectorXd& q, const Eigen::Vector3d& direction) const;

 private:
  double position(const urdf::Joint& joint, const Eigen::VectorXd& q) const;
  /// Velocity of a link's centre of mass (rows 0-2) and its angular velocity (3-5) per coordinate.
  Eigen::MatrixXd jacobian(const std::string& link, const Eigen::VectorXd& q) const;
  Eigen::Isometry3d centre(const std::string& link, const Eigen::VectorXd& q) const;

  std::shared_ptr<urdf::ModelInterface> model_;
  std::vector<std::string> coordinates_;
};

}  // namespace sinew

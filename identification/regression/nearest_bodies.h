// SPDX-License-Identifier: GPL-3.0-or-later
// Of estimated mass properties, those that some body can have. Numbered as everywhere: mass [kg],
// first moments x, y, z [kg m], moments of inertia xx, yy, zz, xy, xz, yz [kg m^2] about the origin
// of the link's frame.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sinew::diagnosis {

using BodyParameters = Eigen::Matrix<double, 10, 1>;

/// The ten numbers as a matrix (symbolic/model/pseudo_inertia.h), and back.
Eigen::Matrix4d pseudo_inertia_matrix(const BodyParameters& parameters);
BodyParameters body_parameters(const Eigen::Matrix4d& pseudo_inertia);

/// A link some of whose ten numbers were estimated, as changes of `before`.
struct EstimatedBody {
  std::vector<int> estimated;  ///< which of the ten, in the order of the estimates
  BodyParameters before = BodyParameters::Zero();
  double reach = 1.0;  ///< m: its mass is no farther from its origin
  /// All ten were estimated, but it is a mass at one point of a link that carried nothing before.
  bool as_point = false;
  bool has_moments() const;  ///< of its own
};

/// Whether each is a body with these changes; those not estimated are 0. Where no moment was, there
/// is a body for any mass > 0 whose centre is within reach.
bool are_bodies(const std::vector<EstimatedBody>& links, const Eigen::VectorXd& estimates);

struct NearestBodies {
  std::vector<BodyParameters>
      changes;          ///< of `before`, all ten; moments are 0 where none was estimated
  double misfit = 0.0;  ///< d' information d of the difference d to the estimates
};

/// The bodies of least misfit, found over Cholesky factors with logarithms on their diagonals.
/// `information`: inverse covariance of the estimates, which may be singular.
NearestBodies nearest_bodies(const std::vector<EstimatedBody>& links,
                             const Eigen::VectorXd& estimates, const Eigen::MatrixXd& information);

}  // namespace sinew::diagnosis

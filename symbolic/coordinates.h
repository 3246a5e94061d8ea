// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/mechanism.h"

namespace sinew {

/// Generalised coordinates of a mechanism whose joints may be coupled (5.16): a dependent joint
/// follows an independent one, q_dependent = ratio * q_independent, and has no coordinate of its
/// own.
///
/// With J = d(moving joints)/d(coordinates), a constant n_joints x n matrix: joint motion is J q,
/// generalised forces are J^T tau, the mass matrix is J^T M J.
class Coordinates {
 public:
  /// Throws std::invalid_argument where a coupling names no joint or a joint depends on itself.
  explicit Coordinates(const Mechanism& mechanism);

  int count() const { return static_cast<int>(joints_.size()); }
  /// Index into mechanism.joints of each coordinate's own joint.
  const std::vector<int>& joints() const { return joints_; }

  /// Values of all moving joints from values of the coordinates.
  std::vector<GiNaC::ex> of_moving_joints(const std::vector<GiNaC::ex>& coordinates) const;
  /// J^T tau.
  std::vector<GiNaC::ex> projected(const std::vector<GiNaC::ex>& joint_forces) const;
  /// J^T M J, row-major.
  std::vector<GiNaC::ex> projected_matrix(const std::vector<GiNaC::ex>& joint_matrix) const;
  /// A J for a row-major matrix with one column a moving joint.
  std::vector<GiNaC::ex> projected_columns(const std::vector<GiNaC::ex>& matrix) const;

 private:
  struct Follows {
    int coordinate;
    GiNaC::ex ratio;
  };
  std::vector<int> joints_;
  std::vector<Follows> moving_;  // per moving joint
};

}  // namespace sinew

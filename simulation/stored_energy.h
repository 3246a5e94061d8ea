// SPDX-License-Identifier: GPL-3.0-or-later
// Energy from geometry alone, for the audit: nothing of it goes into the equations of motion, so
// that a mistake there cannot hide.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "symbolic/mechanism.h"
#include "symbolic/part.h"

namespace sinew {

/// -sum of m g·c over the bodies [J]; `q`: moving joints; `gravity` in the base frame
/// [m/s²].
double gravity_potential(const Mechanism& mechanism, const double* q,
                         const Eigen::Vector3d& gravity);

/// ½ K (l - l0)² of the lever's spring at a lever angle, with l0 the length at the free angle,
/// plus ½ f² l0/(E S) of the tendon [J].
class TendonEnergy {
 public:
  explicit TendonEnergy(const TendonWithLever& parameters);
  double at(double lever_angle, double force) const;

 private:
  LeverParameters lever_;
  double free_length_ = 0.0;  ///< m, of the spring
  double softness_ = 0.0;     ///< m/N, of the tendon
};

}  // namespace sinew

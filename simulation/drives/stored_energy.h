// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic energy from geometry alone, for the audit: nothing of it goes into the equations of
// motion, so that a mistake there cannot hide.
#pragma once

#include "simulation/bodies/sines.h"
#include "symbolic/parts/part.h"

namespace sinew {

/// ½ K (l - l0)² of the lever's spring at a lever angle, with l0 the length at the free angle, plus
/// ½ f² l0/(E S) of the tendon [J].
class TendonEnergy {
 public:
  explicit TendonEnergy(const TendonWithLever& parameters);
  /// Sum over `count` tendons.
  double at(std::size_t count, const double* lever_angle, const double* force) const;

 private:
  double spring_length(double cosine) const;

  double stiffness_ = 0.0, softness_ = 0.0;  ///< N/m of the spring, m/N of the tendon
  // The spring is the side across from the lever's pivot in a triangle: law of cosines.
  double squares_ = 0.0, swing_ = 0.0;  ///< m²
  double angle_ = 0.0;                  ///< rad, of the lever's corner at lever angle 0
  double free_length_ = 0.0;            ///< m
  mutable std::vector<double> corner_;  ///< rad, for one call after the other
  mutable Sines sines_;
};

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// A spring-loaded lever over which a tendon runs; the geometry is worked out here by itself.
#pragma once

#include "tests/blind/truth/hidden.h"

namespace sinew::trials {

struct LeverShape {
  double stiffness = 6400.0;  ///< N/m of the spring
  double motor_radius = 0.005, lever_radius = 0.004, fixed_radius = 0.004;
  double fixed_x = 0.034, pivot_x = 0.005, pivot_y = -0.005, anchor_x = 0.025, anchor_y = -0.017;
  double arm = 0.014, spring_arm = 0.015, spring_angle = -130.0 * pi / 180.0;
  double rest = 48.0 * pi / 180.0;  ///< the spring is free here
  double reach = 9.5e-3;            ///< usual elongation, m
};

/// Elongation and force over the lever's angle, from rest to beyond the reach. The spring may be
/// stiffer by a share and be drawn by `preload` [m] at rest.
class LeverCurve {
 public:
  LeverCurve(const LeverShape& shape, double stiffer, double preload);
  double angle(double elongation) const;
  double force(double elongation) const;
  double elongation_at(double angle) const;
  double force_at(double angle) const;

 private:
  std::vector<double> angle_, elongation_, force_;
};

/// part.toml of the rig: counts between the angles of rest and of the end of travel.
std::string lever_part(const LeverShape& shape, double travel, double first_count,
                       double last_count);

}  // namespace sinew::trials

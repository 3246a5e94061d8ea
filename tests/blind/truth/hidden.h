// SPDX-License-Identifier: GPL-3.0-or-later
// What a trial may hide, in SI units. Own words and own equations: nothing of the models, the
// effects or the engine is used here.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <string>
#include <vector>

namespace sinew::trials {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

inline constexpr double pi = 3.14159265358979323846;

/// One cause as it acts: `dose` is its size in its own unit, the rest is drawn once a trial.
struct Hidden {
  std::string cause;
  int at = 0;  ///< axis, link, tendon or channel, as the cause says
  double dose = 0.0;
  int law = 0;             ///< which of several formulas that physics offers
  double width = 0.0;      ///< in units of what it is a share of: speeds, ranges, seconds
  double phase = 0.0;      ///< rad
  std::uint64_t seed = 0;  ///< of what comes and goes by chance
};

/// Parameters that the program always fits, which take up what they can of a cause.
enum Fitted : unsigned {
  fits_nothing = 0,
  fits_inertia = 1,
  fits_viscous = 2,
  fits_coulomb = 4,
  fits_offset = 8,
  fits_turning = 16,  ///< how friction turns at a reversal
  fits_all = 31
};

/// A cause that a plant offers at one place.
struct Offer {
  std::string cause, place;  ///< place as people name it: "joint j2", "tendon h3", "motor"
  int at = 0;
  double scale = 1.0;  ///< unit of the limits: friction, effort, range, ... of the place
  bool outside = false;
  unsigned fitted = fits_all;
  std::string parameter;  ///< the finding's parameter that should hold factor * dose; empty: none
  double factor = 1.0;
  int order = 0;  ///< of a ripple
  int sign = 0;   ///< of the dose, where the other one is another cause
};

/// Where an axis is and how it moves; `load`: external effort against the motion.
struct Instant {
  double time = 0.0, q = 0.0, v = 0.0, a = 0.0, load = 0.0;
};

}  // namespace sinew::trials

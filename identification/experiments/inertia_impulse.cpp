// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/inertia_impulse.h"

#include <fmt/format.h>

#include <cmath>

#include "identification/experiments/drive_regressors.h"

namespace sinew {
namespace {

constexpr double bump_inertia_limit = 0.1;  // relative standard error that still says something

std::vector<RippleOrder> first_orders() {
  return {{false, 1.0}, {true, 1.0}};
}

/// Where the torque is at least half its largest: what a user reads an impulse from.
Regression over_impulses(const DriveRegression& drive) {
  std::vector<Eigen::Index> rows;
  const double strong = 0.5 * drive.torque.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < drive.torque.size(); ++i)
    if (std::abs(drive.torque(i)) >= strong) rows.push_back(i);
  return regress(drive.columns(rows, 0), drive.torque(rows));
}

}  // namespace

InertiaResult identify_inertia(const std::vector<DriveStretch>& stretches,
                               const MotorParameters& model, double width) {
  InertiaResult result;
  const DriveRegression drive =
      project_drive(stretches, model.gamma1, model.gear_ratio, first_orders(), width);
  const auto say = [&](const std::string& text) { result.missing.push_back(text); };
  const std::string experiment =
      "expected torque impulses, such as 1 N·m for 50 ms, both ways, with the drive free to move";
  if (drive.torque.size() < 3 * drive.columns.cols()) {
    say(fmt::format("the log is too short: {:.3g} s; {}",
                    static_cast<double>(drive.torque.size()) * width, experiment));
    return result;
  }
  const Regression with = regress(drive.columns, drive.torque), without = over_impulses(drive);
  result.inertia = with.estimate_of(0);
  result.without_friction = without.estimate_of(0);
  result.bias = result.without_friction.value / result.inertia.value - 1.0;
  result.residual = with.residual / drive.torque_per_projection;
  result.residual_without = without.residual / drive.torque_per_projection;
  if (!with.identifiable) {
    say(fmt::format("inertia, friction and ripple act alike in this log; {}", experiment));
  } else if (!(result.inertia.standard_error < bump_inertia_limit * result.inertia.value)) {
    say(fmt::format("the inertia is {:.3g} +- {:.2g} kg·m²: it moves too little; {}",
                    result.inertia.value, result.inertia.standard_error, experiment));
  } else if (result.residual > 2.0 * drive.noise + 1e-3 * drive.torque.cwiseAbs().maxCoeff() /
                                                       drive.torque_per_projection) {
    say(fmt::format(
        "the motion leaves {:.2g} N·m unexplained where noise is {:.2g} N·m, as steps of "
        "torque between samples do; {}",
        result.residual, drive.noise, experiment));
  } else {
    result.identified = true;
  }
  return result;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/ripple_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinew {
namespace {

using std::numbers::pi;
constexpr double significance = 5.0;      // standard errors
constexpr double samples_per_wave = 0.6;  // bump width in periods of the fastest wave looked for

/// Travel of all stretches [rad].
double travel(const std::vector<DriveStretch>& stretches) {
  double sum = 0.0;
  for (const DriveStretch& s : stretches) sum += s.theta.maxCoeff() - s.theta.minCoeff();
  return sum;
}

double fastest(const std::vector<DriveStretch>& stretches) {
  double speed = 0.0;
  for (const DriveStretch& s : stretches)
    speed = std::max(speed, std::abs(s.theta(s.theta.size() - 1) - s.theta(0)) /
                                (static_cast<double>(s.theta.size() - 1) * s.period));
  return speed;
}

/// The constant velocities alone, one stretch each.
std::vector<DriveStretch> steady(const std::vector<DriveStretch>& stretches) {
  std::vector<DriveStretch> all;
  for (const Plateau& p : plateaus(stretches)) {
    const DriveStretch& s = stretches[p.stretch];
    const long count = p.last - p.first;
    all.push_back({s.period, s.theta.segment(p.first, count), s.omega.segment(p.first, count),
                   s.torque.segment(p.first, count)});
  }
  return all;
}

/// The model's friction and a constant torque of its own for each velocity: what is fitted along.
/// Velocity ripple is made by the ripple looked for and acts on it through the friction's slope, so
/// that its viscous part must not be left out: that would be a bias of the ripple.
Eigen::MatrixXd common_columns(const DriveRegression& drive, const MotorParameters& model) {
  const auto count = static_cast<Eigen::Index>(drive.rows.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(drive.columns.rows(), 1 + count);
  const bool known = model.gamma2 * model.gamma1 > 0.0 || model.gamma3 > 0.0;
  columns.col(0) = known ? Eigen::VectorXd(model.gamma2 * drive.columns.col(1) +
                                           model.gamma3 * drive.columns.col(2))
                         : Eigen::VectorXd(drive.columns.col(2));
  Eigen::Index row = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Index rows = drive.rows[static_cast<std::size_t>(k)];
    columns.block(row, 1 + k, rows, 1).setOnes();
    row += rows;
  }
  return columns;
}

std::vector<RippleOrder> candidates(double turned, double gear_ratio, int highest) {
  std::vector<RippleOrder> all;
  for (int order = 1; order <= highest; ++order) {
    all.push_back({true, static_cast<double>(order)});
    // Half a turn of the output at least, or its order is a slope.
    if (turned * order > pi) all.push_back({false, static_cast<double>(order)});
  }
  std::erase_if(all, [&](const RippleOrder& r) {
    return turned * r.per_output_radian(gear_ratio) < 2.0 * pi;
  });
  return all;
}

double strength(const Regression& r, Eigen::Index first) {
  return std::hypot(r.values(first) / r.standard_errors(first),
                    r.values(first + 1) / r.standard_errors(first + 1));
}

FittedRipple fitted(const Regression& r, const RippleOrder& order, Eigen::Index first) {
  FittedRipple f;
  f.order = order;
  f.sine = r.estimate_of(first);
  f.cosine = r.estimate_of(first + 1);
  const double s = f.sine.value, c = f.cosine.value, amplitude = std::hypot(s, c);
  const Eigen::Matrix2d covariance = r.covariance.block<2, 2>(first, first);
  const Eigen::Vector2d along(s / amplitude, c / amplitude), across(-along(1), along(0));
  f.amplitude = estimate(amplitude, std::sqrt(along.dot(covariance * along)), r.freedom);
  f.phase =
      estimate(std::atan2(c, s), std::sqrt(across.dot(covariance * across)) / amplitude, r.freedom);
  return f;
}

}  // namespace

RippleResult identify_ripple(const std::vector<DriveStretch>& whole, const MotorParameters& model,
                             int highest) {
  RippleResult result;
  const std::vector<DriveStretch> stretches = steady(whole);
  const double speed = fastest(stretches);
  const std::string experiment = fmt::format(
      "expected constant velocities over a turn of the output shaft, slow enough for ten samples a "
      "motor turn and its {} harmonics",
      highest);
  const double turned = stretches.empty() ? 0.0 : travel(stretches);
  std::vector<RippleOrder> left = candidates(turned, model.gear_ratio, highest);
  if (speed == 0.0 || left.empty()) {
    result.missing.push_back("no constant velocity, or less than a motor turn; " + experiment);
    return result;
  }
  const double period = stretches.front().period;
  const auto slow_enough = [&](const RippleOrder& r) {
    return 2.0 * pi / (r.per_output_radian(model.gear_ratio) * speed) > 10.0 * period;
  };
  for (const RippleOrder& r : left)
    if (!slow_enough(r))
      result.missing.push_back(
          fmt::format("order {} of the {} shaft is too fast for this log at "
                      "{:.3g} rad/s; {}",
                      r.order, r.input ? "input" : "output", speed, experiment));
  std::erase_if(left, [&](const RippleOrder& r) { return !slow_enough(r); });
  if (left.empty()) return result;
  double quickest = 0.0;
  for (const RippleOrder& r : left)
    quickest = std::max(quickest, r.per_output_radian(model.gear_ratio));
  result.width = samples_per_wave * 2.0 * pi / (quickest * speed);

  const DriveRegression drive =
      project_drive(stretches, model.gamma1, model.gear_ratio, left, result.width);
  // At constant velocity theta'' and ripple act alike: the inertia has to be known.
  const Eigen::VectorXd torque = drive.torque - motor_inertia(model) * drive.columns.col(0);
  const Eigen::MatrixXd along = common_columns(drive, model);
  const Eigen::Index common = along.cols(), projected = 3;
  std::vector<std::size_t> kept(left.size());
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = i;
  // All of them together first; then without those that explain nothing.
  Regression r;
  for (int round = 0; round < 2; ++round) {
    Eigen::MatrixXd columns(drive.columns.rows(),
                            common + 2 * static_cast<Eigen::Index>(kept.size()));
    columns.leftCols(common) = along;
    for (std::size_t i = 0; i < kept.size(); ++i)
      columns.middleCols(common + 2 * static_cast<Eigen::Index>(i), 2) =
          drive.columns.middleCols(projected + 2 * static_cast<Eigen::Index>(kept[i]), 2);
    r = regress(columns, torque);
    if (!r.identifiable) {
      result.missing.push_back("ripple, friction and inertia act alike in this log; " + experiment);
      return result;
    }
    if (round == 1) break;
    std::vector<std::size_t> strong;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (strength(r, common + 2 * static_cast<Eigen::Index>(i)) > significance)
        strong.push_back(kept[i]);
    kept = strong;
  }
  result.residual = r.residual / drive.torque_per_projection;
  for (std::size_t i = 0; i < kept.size(); ++i)
    result.ripples.push_back(fitted(r, left[kept[i]], common + 2 * static_cast<Eigen::Index>(i)));
  return result;
}

}  // namespace sinew

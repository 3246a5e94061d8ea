// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/drive_regressors.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

Eigen::MatrixXd columns_of(const DriveStretch& s, const BumpProjection& bumps, double gamma1,
                           double gear_ratio, const std::vector<RippleOrder>& ripples) {
  const Eigen::VectorXd acceleration = bumps.all(s.theta, 2);
  Eigen::MatrixXd columns(acceleration.size(), 3 + 2 * static_cast<Eigen::Index>(ripples.size()));
  columns.col(0) = acceleration;
  columns.col(1) = bumps.all((gamma1 * s.omega).atan());
  columns.col(2) = bumps.all(s.theta, 1);
  Eigen::Index next = 3;
  for (const RippleOrder& ripple : ripples) {
    const Eigen::ArrayXd angle = s.theta * ripple.per_output_radian(gear_ratio);
    columns.col(next++) = bumps.all(angle.sin());
    columns.col(next++) = bumps.all(angle.cos());
  }
  return columns;
}

}  // namespace

DriveRegression project_drive(const std::vector<DriveStretch>& stretches, double gamma1,
                              double gear_ratio, const std::vector<RippleOrder>& ripples,
                              double width) {
  DriveRegression all;
  for (const DriveStretch& s : stretches) {
    const BumpProjection bumps(std::max(7L, std::lround(width / s.period)), s.period);
    const Eigen::MatrixXd columns = columns_of(s, bumps, gamma1, gear_ratio, ripples);
    const Eigen::VectorXd torque = bumps.all(s.torque);
    const Eigen::Index before = all.torque.size();
    all.columns.conservativeResize(before + columns.rows(), columns.cols());
    all.columns.bottomRows(columns.rows()) = columns;
    all.torque.conservativeResize(before + torque.size());
    all.torque.tail(torque.size()) = torque;
    all.rows.push_back(torque.size());
    all.noise = std::max(all.noise, bumps.noise_gain() * white_noise_rms(s.torque));
    all.torque_per_projection = bumps.of(Eigen::ArrayXd::Ones(bumps.width()), 0);
  }
  return all;
}

}  // namespace sinew

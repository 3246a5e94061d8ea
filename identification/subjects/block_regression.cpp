// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/block_regression.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "identification/logs/filter.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kHighest = 10.0;    // Hz
constexpr Index kTimeBlocks = 10;    // of a log
constexpr Index kDrive = 4;          // columns of a joint's own drive
constexpr double kStandstill = 0.1;  // of the joint's rms speed: there its friction is anything

}  // namespace

SmoothEfforts smooth_efforts(const Recording& log, const EffortModel& model) {
  const double cutoff = std::min(kHighest, 0.1 / log.step);
  const auto end = static_cast<Index>(std::ceil(driven_edge / log.step));
  const Index rows = std::max<Index>(0, log.q.rows() - 2 * end);
  MatrixXd measured(log.q.rows(), static_cast<Index>(log.target.size()));
  for (Index c = 0; c < measured.cols(); ++c)
    measured.col(c) = log.target[static_cast<std::size_t>(c)];
  const Motion motion = differentiate(log.q, log.step, cutoff);
  const Motion efforts = differentiate(measured, log.step, cutoff);
  const MatrixXd none = MatrixXd::Zero(log.q.rows(), log.q.cols());
  const auto inner = [&](const MatrixXd& x) -> MatrixXd { return x.middleRows(end, rows); };
  return {inner(motion.qd), inner(motion.qdd), inner(efforts.q),
          inner(model(log, motion.q, motion.qd, motion.qdd)),
          inner(model(log, motion.q, none, none))};
}

void BlockRegression::add(const SmoothEfforts& log, Index joint, const MatrixXd& columns) {
  const VectorXd speed = log.qd.col(joint);
  const Index n = speed.size(), wide = own_ + kDrive;
  const double usual = speed.norm() / std::sqrt(std::max(1.0, static_cast<double>(n)));
  for (Index b = 0; b < kTimeBlocks; ++b) {
    MatrixXd gram = MatrixXd::Zero(wide, wide);
    VectorXd target = VectorXd::Zero(wide), x(wide);
    for (Index k = n * b / kTimeBlocks; k < n * (b + 1) / kTimeBlocks; ++k) {
      if (std::abs(speed(k)) < kStandstill * usual) continue;
      x << columns.row(k).transpose(), log.qdd(k, joint), speed(k), speed(k) > 0.0 ? 1.0 : -1.0,
          1.0;
      gram += x * x.transpose();
      target += x * log.measured(k, joint);
    }
    gram_.push_back(std::move(gram));
    target_.push_back(std::move(target));
  }
}

VectorXd BlockRegression::solved(int without) const {
  const Index wide = own_ + kDrive;
  MatrixXd gram = MatrixXd::Zero(wide, wide);
  VectorXd target = VectorXd::Zero(wide);
  for (int b = 0; b < static_cast<int>(gram_.size()); ++b) {
    if (b == without) continue;
    gram += gram_[static_cast<std::size_t>(b)];
    target += target_[static_cast<std::size_t>(b)];
  }
  const VectorXd scale = gram.diagonal().cwiseSqrt().cwiseMax(1e-150).cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * gram * scale.asDiagonal();
  const VectorXd right = scale.asDiagonal() * target;
  const VectorXd solution = scaled.completeOrthogonalDecomposition().solve(right);
  return scale.cwiseProduct(solution).head(own_);
}

std::vector<Share> BlockRegression::shares() const {
  const VectorXd all = solved(-1);
  VectorXd squares = VectorXd::Zero(own_);
  for (int b = 0; b < static_cast<int>(gram_.size()); ++b) squares += (solved(b) - all).cwiseAbs2();
  const auto blocks = std::max(1.0, static_cast<double>(gram_.size()));
  std::vector<Share> result;
  for (Index k = 0; k < own_; ++k)
    result.push_back({all(k), std::sqrt(squares(k) * (blocks - 1.0) / blocks)});
  return result;
}

}  // namespace sinew::diagnosis

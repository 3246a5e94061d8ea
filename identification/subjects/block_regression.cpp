// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/block_regression.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "identification/logs/filter.h"
#include "identification/subjects/driven_subject.h"
#include "identification/subjects/slow_recording.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kTimeBlocks = 10;    // of a log
constexpr double kStandstill = 0.1;  // of the joint's rms speed: there its friction is anything

}  // namespace

SmoothEfforts smooth_efforts(const Recording& log, const EffortModel& model) {
  const double cutoff = column_cutoff(log.step);
  const auto end = static_cast<Index>(std::ceil(driven_edge / log.step));
  const Index rows = std::max<Index>(0, log.q.rows() - 2 * end);
  MatrixXd measured(log.q.rows(), static_cast<Index>(log.target.size()));
  for (Index c = 0; c < measured.cols(); ++c)
    measured.col(c) = log.target[static_cast<std::size_t>(c)];
  const Motion motion = differentiate(log.q, log.step, cutoff);
  const Motion efforts = differentiate(measured, log.step, cutoff);
  const MatrixXd none = MatrixXd::Zero(log.q.rows(), log.q.cols());
  const auto inner = [&](const MatrixXd& x) -> MatrixXd { return x.middleRows(end, rows); };
  return {inner(motion.qd),
          inner(motion.qdd),
          inner(efforts.q),
          inner(model(log, motion.q, motion.qd, motion.qdd)),
          inner(model(log, motion.q, none, none)),
          inner(model(log, motion.q, none, motion.qdd))};
}

MatrixXd own_drive(const VectorXd& speed, const VectorXd& acceleration) {
  MatrixXd x(speed.size(), 4);
  x << acceleration, speed, speed.cwiseSign(), VectorXd::Ones(speed.size());
  return x;
}

VectorXd in_motion(const VectorXd& speed) {
  const double usual = speed.norm() / std::sqrt(std::max(1.0, static_cast<double>(speed.size())));
  return (speed.array().abs() >= kStandstill * usual).cast<double>().matrix();
}

void BlockRegression::add(const MatrixXd& columns, const VectorXd& target, const VectorXd& counts) {
  const Index n = target.size();
  for (Index b = 0; b < kTimeBlocks; ++b) {
    const Index first = n * b / kTimeBlocks, count = n * (b + 1) / kTimeBlocks - first;
    const MatrixXd x = counts.segment(first, count).asDiagonal() * columns.middleRows(first, count);
    gram_.push_back(x.transpose() * x);
    target_.push_back(x.transpose() * target.segment(first, count));
  }
}

void BlockRegression::add_joint(const SmoothEfforts& log, Index joint, const MatrixXd& columns) {
  MatrixXd all(columns.rows(), columns.cols() + 4);
  all << columns, own_drive(log.qd.col(joint), log.qdd.col(joint));
  add(all, log.measured.col(joint), in_motion(log.qd.col(joint)));
}

VectorXd BlockRegression::solved(int without) const {
  const Index wide = gram_.front().cols();
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
  return scale.cwiseProduct(solution);
}

template <typename Function>
Share BlockRegression::estimated(const Function& of_coefficients) const {
  const double all = of_coefficients(solved(-1));
  double squares = 0.0;
  for (int b = 0; b < static_cast<int>(gram_.size()); ++b) {
    const double off = of_coefficients(solved(b)) - all;
    squares += off * off;
  }
  const auto blocks = std::max(1.0, static_cast<double>(gram_.size()));
  return {all, std::sqrt(squares * (blocks - 1.0) / blocks)};
}

std::vector<Share> BlockRegression::shares() const {
  std::vector<Share> result;
  for (Index k = 0; k < asked_; ++k)
    result.push_back(estimated([k](const VectorXd& c) { return c(k); }));
  return result;
}

}  // namespace sinew::diagnosis

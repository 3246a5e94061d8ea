// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/clustered_errors.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kLeastOfALog = 3;  // however short it is

/// Of a training log how many stretches, and how many there are before it.
struct LogStretches {
  int before = 0, count = 0;
};

std::map<int, LogStretches> stretches_of_logs(const Design& design) {
  std::map<int, double> seconds;
  double all = 0.0;
  for (const Segment& s : design.segments())
    if (!s.holdout && !seconds.contains(s.recording)) {
      seconds[s.recording] = static_cast<double>(s.samples) / s.rate_hz;
      all += seconds[s.recording];
    }
  std::map<int, LogStretches> stretches;
  int before = 0;
  for (const auto& [recording, own] : seconds) {
    const int count = std::max(kLeastOfALog, static_cast<int>(std::lround(own / all * kStretches)));
    stretches[recording] = {before, count};
    before += count;
  }
  return stretches;
}

/// A stretch's part of the normal equations, at the fit of all.
struct StretchScores {
  MatrixXd gram;
  VectorXd score;
};

void add_segment(const Segment& segment, const LogStretches& of_log, const ActingRows& rows,
                 const VectorXd& residual, std::vector<StretchScores>& stretches) {
  const std::vector<Index>& at = rows.at;
  if (at.empty()) return;
  const MatrixXd x = from_band(rows.a, segment.samples);
  const VectorXd left = from_band(residual, segment.samples);
  for (int b = 0; b < of_log.count; ++b) {
    const Index from = segment.samples * b / of_log.count,
                count = segment.samples * (b + 1) / of_log.count - from;
    const auto part = x.middleRows(from, count);
    StretchScores& own = stretches[static_cast<std::size_t>(of_log.before + b)];
    own.gram(at, at) += part.transpose() * part;
    own.score(at) += part.transpose() * left.segment(from, count);
  }
}

/// R with R R' the pseudo-inverse of the gram: without directions in which nothing is told.
MatrixXd inverse_root(const MatrixXd& gram) {
  const VectorXd scale =
      gram.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 0.0; });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(
      MatrixXd(scale.asDiagonal() * gram * scale.asDiagonal()));
  const double limit = 1e-10 * std::max(eigen.eigenvalues().maxCoeff(), 1e-300);
  const VectorXd root = eigen.eigenvalues().unaryExpr(
      [limit](double e) { return e > limit ? 1.0 / std::sqrt(e) : 0.0; });
  return scale.asDiagonal() * eigen.eigenvectors() * root.asDiagonal();
}

/// By how much a stretch moves the coefficients, grown by what the fit has taken of its residual.
VectorXd moved_by(const StretchScores& own, const MatrixXd& root) {
  constexpr double kLeastLeft = 0.02;  // of a direction: one that a stretch alone tells
  const Eigen::SelfAdjointEigenSolver<MatrixXd> taken(root.transpose() * own.gram * root);
  const VectorXd grown = (1.0 - taken.eigenvalues().array()).max(kLeastLeft).rsqrt();
  const MatrixXd& v = taken.eigenvectors();
  const VectorXd score = v.transpose() * (root.transpose() * own.score);
  return root * (v * grown.cwiseProduct(score));
}

}  // namespace

ActingRows acting_rows(const Stack& stacked, const std::vector<VectorXd>& shapes,
                       std::size_t segment) {
  const MatrixXd& own = stacked.a[segment];
  if (own.rows() == 0) return {};
  const auto more = static_cast<Index>(shapes.size());
  ActingRows rows{MatrixXd(own.rows(), own.cols() + more), stacked.at[segment]};
  rows.a.leftCols(own.cols()) = own;
  for (Index k = 0; k < more; ++k) {
    rows.a.col(own.cols() + k) =
        shapes[static_cast<std::size_t>(k)].segment(stacked.first_row[segment], own.rows());
    rows.at.push_back(stacked.coefficients + k);
  }
  return rows;
}

MatrixXd covariance_by_stretches(const Design& design, const Stack& stacked,
                                 const std::vector<VectorXd>& shapes, const VectorXd& residual,
                                 const MatrixXd& gram) {
  const Index wide = gram.cols();
  MatrixXd covariance = MatrixXd::Zero(wide, wide);
  const std::map<int, LogStretches> logs = stretches_of_logs(design);
  if (logs.empty() || wide == 0) return covariance;
  const LogStretches& last = logs.rbegin()->second;
  std::vector<StretchScores> stretches(static_cast<std::size_t>(last.before + last.count),
                                       {MatrixXd::Zero(wide, wide), VectorXd::Zero(wide)});
  for (std::size_t s = 0; s < design.segments().size(); ++s) {
    const Index from = stacked.first_row[s], rows = stacked.first_row[s + 1] - from;
    if (rows == 0) continue;
    const Segment& segment = design.segments()[s];
    add_segment(segment, logs.at(segment.recording), acting_rows(stacked, shapes, s),
                residual.segment(from, rows), stretches);
  }
  const MatrixXd root = inverse_root(gram);
  for (const StretchScores& own : stretches) {
    const VectorXd moved = moved_by(own, root);
    covariance += moved * moved.transpose();
  }
  return covariance;
}

}  // namespace sinew::diagnosis

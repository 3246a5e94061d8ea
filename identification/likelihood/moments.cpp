// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/moments.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/likelihood/decision_constants.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// rms of what was measured in the band, per channel.
VectorXd measured_rms(const ColumnSums& sums) {
  return sums.measured.cwiseQuotient(sums.samples.cwiseMax(1e-300)).cwiseSqrt().cwiseMax(1e-12);
}

/// What is known of a shape's coefficient beforehand: its standard deviation, or infinity.
double known_spread(const Hypotheses& all, std::size_t shape, Index coefficient) {
  const Hypothesis& h = all.list[static_cast<std::size_t>(all.shapes[shape].hypothesis)];
  const auto& linear = h.source->linear;
  const auto p = static_cast<std::size_t>(coefficient);
  return p < linear.size() && linear[p].spread > 0.0 ? linear[p].spread
                                                     : std::numeric_limits<double>::infinity();
}

/// Where each shape's columns stand; fills ranges, coefficients and scales. Gives the place of
/// every column among the sums' columns.
std::vector<Index> lay_out(const ColumnSums& sums, const Hypotheses& all, Moments& m) {
  const VectorXd inverse = measured_rms(sums).cwiseAbs2().cwiseInverse();
  const VectorXd energy = sums.energy.transpose() * inverse;
  std::vector<double> scales;
  std::vector<Index> at;
  Index first = 0;
  for (const Index width : sums.width) {
    m.of_shape.push_back({static_cast<Index>(at.size()), 0});
    for (Index c = 0; c < width; ++c) {
      if (!(energy(first + c) > 0.0)) continue;
      scales.push_back(std::min(std::sqrt(sums.acting(first + c) / energy(first + c)),
                                known_spread(all, m.of_shape.size() - 1, c) / kLargestSize));
      at.push_back(sums.free + first + c);
      m.coefficient.push_back(static_cast<int>(c));
      ++m.of_shape.back().count;
    }
    first += width;
  }
  m.scale = VectorXd::Map(scales.data(), static_cast<Index>(scales.size()));
  return at;
}

/// The model's free part taken out of everything.
void project_out_free(const ColumnSums& sums, const std::vector<Index>& at, Moments& m) {
  MatrixXd base = sums.gram.topLeftCorner(sums.free, sums.free);
  base.triangularView<Eigen::StrictlyUpper>() = base.transpose();
  const VectorXd base_target = sums.target.head(sums.free);
  const MatrixXd cross =
      m.scale.asDiagonal() * MatrixXd(sums.gram(at, Eigen::seqN(Index{0}, sums.free)));
  const MatrixXd inverse = scaled_pseudo_inverse(base);
  const MatrixXd solved = cross * inverse;
  m.gram.noalias() -= solved * cross.transpose();
  m.target -= solved * base_target;
  m.deviance -= base_target.dot(inverse * base_target);
  m.rows -= static_cast<double>(sums.free);
}

/// Columns that stand for their hypothesis among small errors, and the share of it each carries.
void choose_representatives(const Moments& m, const Hypotheses& all, std::vector<Index>& at,
                            std::vector<double>& variance) {
  for (const Hypothesis& h : all.list) {
    std::vector<Index> own;
    const std::size_t count = h.shapes.size();
    for (const std::size_t k : {count / 3, 2 * count / 3}) {
      if (count == 0 || (k == 2 * count / 3 && count <= 2)) continue;
      const Moments::Range& range = m.of_shape[static_cast<std::size_t>(h.shapes[k])];
      for (Index c = 0; c < range.count; ++c) own.push_back(range.first + c);
    }
    for (const Index column : own) {
      at.push_back(column);
      variance.push_back(1.0 / static_cast<double>(own.size()));
    }
  }
}

}  // namespace

Moments moments_of(const ColumnSums& sums, const Hypotheses& all) {
  Moments m;
  const std::vector<Index> at = lay_out(sums, all, m);
  const auto columns = static_cast<Index>(at.size());
  m.gram.resize(columns, columns);
  for (Index c = 0; c < columns; ++c)
    for (Index r = c; r < columns; ++r)
      m.gram(r, c) = m.gram(c, r) =
          m.scale(r) * m.scale(c) *
          sums.gram(at[static_cast<std::size_t>(r)], at[static_cast<std::size_t>(c)]);
  m.target = m.scale.cwiseProduct(VectorXd(sums.target(at)));
  m.deviance = sums.deviance;
  m.rows = sums.rows;
  if (sums.free > 0) project_out_free(sums, at, m);
  return m;
}

Moments moments_of(const Design& design, const Hypotheses& all, const Whitening& whitening) {
  return moments_of(column_sums(design, all, whitening), all);
}

SmallErrors::SmallErrors(const Moments& m, const Hypotheses& all, double share) : m_(m) {
  std::vector<Index> at;
  std::vector<double> variance;
  if (share > 0.0) choose_representatives(m, all, at, variance);
  const auto count = static_cast<Index>(at.size());
  const VectorXd size = share * VectorXd::Map(variance.data(), count).cwiseSqrt();
  const MatrixXd cross = size.asDiagonal() * MatrixXd(m.gram(at, Eigen::all));
  MatrixXd inner = MatrixXd(cross(Eigen::all, at)) * size.asDiagonal();
  inner += MatrixXd::Identity(count, count);
  const Eigen::LLT<MatrixXd> factor(inner);
  taken_ = factor.matrixL().solve(cross);
  const VectorXd own = factor.matrixL().solve(VectorXd(size.cwiseProduct(m.target(at))));
  target_ = m.target - taken_.transpose() * own;
  log_likelihood_ = 0.5 * own.squaredNorm() - 0.5 * m.deviance;
  if (count > 0) log_likelihood_ -= MatrixXd(factor.matrixL()).diagonal().array().log().sum();
}

MatrixXd SmallErrors::gram(const std::vector<Index>& rows,
                           const std::vector<Index>& columns) const {
  MatrixXd g = m_.gram(rows, columns);
  if (taken_.rows() > 0)
    g -= MatrixXd(taken_(Eigen::all, rows)).transpose() * MatrixXd(taken_(Eigen::all, columns));
  return g;
}

MatrixXd SmallErrors::gram_with_all(const std::vector<Index>& columns) const {
  MatrixXd g = m_.gram(Eigen::all, columns);
  if (taken_.rows() > 0) g -= taken_.transpose() * MatrixXd(taken_(Eigen::all, columns));
  return g;
}

}  // namespace sinew::diagnosis

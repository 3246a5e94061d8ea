// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/moments.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// rms of what was measured in the band, per channel, in the training logs.
VectorXd measured_rms(const Design& design) {
  VectorXd energy = VectorXd::Zero(design.problem().channels), samples = energy;
  for (std::size_t i = 0; i < design.segments().size(); ++i) {
    const Segment& s = design.segments()[i];
    if (s.holdout) continue;
    VectorXd whole = design.target(static_cast<int>(i));
    if (const auto known = design.known(static_cast<int>(i), 0)) whole += *known;
    energy(s.channel) += whole.squaredNorm();
    samples(s.channel) += design.window(static_cast<int>(i)).squaredNorm();
  }
  return energy.cwiseQuotient(samples.cwiseMax(1e-300)).cwiseSqrt().cwiseMax(1e-12);
}

/// What a column's coefficients are multiplied with, 0 for one that is zero: one entry a
/// coefficient of the shape.
VectorXd scales_of(const Design& design, const BandColumns& columns, const VectorXd& rms) {
  VectorXd energy;
  double samples = 0.0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Segment& s = design.segments()[i];
    if (s.holdout || columns[i].cols() == 0) continue;
    if (energy.size() == 0) energy = VectorXd::Zero(columns[i].cols());
    energy += columns[i].colwise().squaredNorm().transpose() / (rms(s.channel) * rms(s.channel));
    samples += design.window(static_cast<int>(i)).squaredNorm();
  }
  return energy.unaryExpr([&](double e) { return e > 0.0 ? std::sqrt(samples / e) : 0.0; });
}

/// Where each shape's columns stand; fills ranges, coefficients and scales.
void lay_out(const Design& design, const Hypotheses& all, Moments& m) {
  const VectorXd rms = measured_rms(design);
  std::vector<double> scales;
  for (const Shape& shape : all.shapes) {
    const VectorXd own = scales_of(design, shape.columns, rms);
    m.of_shape.push_back({static_cast<Index>(scales.size()), 0});
    for (Index c = 0; c < own.size(); ++c) {
      if (!(own(c) > 0.0)) continue;
      scales.push_back(own(c));
      m.coefficient.push_back(static_cast<int>(c));
      ++m.of_shape.back().count;
    }
  }
  m.scale = VectorXd::Map(scales.data(), static_cast<Index>(scales.size()));
}

/// A segment's whitened columns that are not zero, and where they stand.
struct Rows {
  MatrixXd x, base;
  VectorXd y;
  std::vector<Index> at, base_at;
};

Rows rows_of(const Hypotheses& all, const Moments& m, const VectorXd& weight, std::size_t s) {
  Rows rows;
  for (std::size_t i = 0; i < all.shapes.size(); ++i)
    if (all.shapes[i].columns[s].cols() > 0)
      for (Index c = 0; c < m.of_shape[i].count; ++c) rows.at.push_back(m.of_shape[i].first + c);
  rows.x.resize(weight.size(), static_cast<Index>(rows.at.size()));
  Index place = 0;
  for (std::size_t i = 0; i < all.shapes.size(); ++i) {
    const MatrixXd& columns = all.shapes[i].columns[s];
    if (columns.cols() == 0) continue;
    for (Index c = 0; c < m.of_shape[i].count; ++c) {
      const Index at = m.of_shape[i].first + c;
      rows.x.col(place++) =
          m.scale(at) *
          weight.cwiseProduct(columns.col(m.coefficient[static_cast<std::size_t>(at)]));
    }
  }
  const std::vector<Index> first = first_columns(all.parts.base);
  for (std::size_t t = 0; t < all.parts.base.terms.size(); ++t) {
    const MatrixXd& columns = all.parts.base.terms[t].columns[s];
    for (Index c = 0; c < columns.cols(); ++c) rows.base_at.push_back(first[t] + c);
  }
  rows.base.resize(weight.size(), static_cast<Index>(rows.base_at.size()));
  place = 0;
  for (const Term& term : all.parts.base.terms) {
    const MatrixXd& columns = term.columns[s];
    if (columns.cols() == 0) continue;
    rows.base.middleCols(place, columns.cols()) = weight.asDiagonal() * columns;
    place += columns.cols();
  }
  rows.y = weight.cwiseProduct(all.parts.base.target[s]);
  return rows;
}

/// Sums over segments, and what the model's free part takes of them.
struct Sums {
  MatrixXd base, cross;
  VectorXd base_target;
};

/// Products of the rows' columns with each other, the lower half.
MatrixXd lower_gram(const Rows& rows) {
  MatrixXd own = MatrixXd::Zero(rows.x.cols(), rows.x.cols());
  own.selfadjointView<Eigen::Lower>().rankUpdate(rows.x.transpose());
  return own;
}

/// Places ascend, so that the lower half stays the lower half.
void add(const Rows& rows, const MatrixXd& own, Moments& m, Sums& sums) {
  for (std::size_t c = 0; c < rows.at.size(); ++c)
    for (std::size_t r = c; r < rows.at.size(); ++r)
      m.gram(rows.at[r], rows.at[c]) += own(static_cast<Index>(r), static_cast<Index>(c));
  m.target(rows.at) += rows.x.transpose() * rows.y;
  m.deviance += rows.y.squaredNorm();
  m.rows += static_cast<double>(rows.y.size());
  if (rows.base_at.empty()) return;
  sums.base(rows.base_at, rows.base_at) += rows.base.transpose() * rows.base;
  sums.base_target(rows.base_at) += rows.base.transpose() * rows.y;
  if (!rows.at.empty()) sums.cross(rows.base_at, rows.at) += rows.base.transpose() * rows.x;
}

/// One segment's.
struct Products {
  Rows rows;
  MatrixXd gram;
};

constexpr std::size_t kAtOnce = 4;  // segments whose rows are in memory together

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

Moments moments_of(const Design& design, const Hypotheses& all, const Weights& weights) {
  Moments m;
  lay_out(design, all, m);
  const Index columns = m.scale.size();
  m.gram = MatrixXd::Zero(columns, columns);
  m.target = VectorXd::Zero(columns);
  const Index base = first_columns(all.parts.base).back();
  Sums sums{MatrixXd::Zero(base, base), MatrixXd::Zero(base, columns), VectorXd::Zero(base)};
  std::vector<std::size_t> segments;
  for (std::size_t s = 0; s < weights.size(); ++s)
    if (weights[s].size() > 0) segments.push_back(s);
  // Added in their order, whichever is ready first: a sum's last bit depends on it.
  for (std::size_t from = 0; from < segments.size(); from += kAtOnce) {
    std::vector<Products> part(std::min(kAtOnce, segments.size() - from));
    tbb::parallel_for(std::size_t{0}, part.size(), [&](std::size_t i) {
      const std::size_t s = segments[from + i];
      part[i].rows = rows_of(all, m, weights[s], s);
      part[i].gram = lower_gram(part[i].rows);
    });
    for (const Products& p : part) add(p.rows, p.gram, m, sums);
  }
  m.gram.triangularView<Eigen::StrictlyUpper>() = m.gram.transpose();
  if (base == 0) return m;
  const MatrixXd inverse = scaled_pseudo_inverse(sums.base);
  const MatrixXd solved = inverse * sums.cross;
  m.gram -= sums.cross.transpose() * solved;
  m.target -= solved.transpose() * sums.base_target;
  m.deviance -= sums.base_target.dot(inverse * sums.base_target);
  m.rows -= static_cast<double>(base);
  return m;
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

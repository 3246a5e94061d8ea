// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/column_sums.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kAtOnce = 4;  // segments whose rows are in memory together

Index width_of(const BandColumns& columns) {
  for (const MatrixXd& part : columns)
    if (part.cols() > 0) return part.cols();
  return 0;
}

/// A segment's columns that act there, in their order, and where they stand among all.
struct ActingColumns {
  std::vector<const MatrixXd*> parts;
  std::vector<Index> at;
};

ActingColumns acting_columns(const Hypotheses& all, const ColumnSums& sums, std::size_t segment) {
  ActingColumns acting;
  Index first = 0;
  const auto take = [&](const MatrixXd& part, Index width) {
    if (part.cols() > 0) acting.parts.push_back(&part);
    for (Index c = 0; c < part.cols(); ++c) acting.at.push_back(first + c);
    first += width;
  };
  for (const Term& term : all.parts.base.terms) take(term.columns[segment], width_of(term.columns));
  for (std::size_t i = 0; i < all.shapes.size(); ++i)
    take(all.shapes[i].columns[segment], sums.width[i]);
  return acting;
}

/// One segment's products, the lower half.
struct Products {
  std::vector<Index> at;
  MatrixXd gram;
  VectorXd target;
  double deviance = 0.0, rows = 0.0;
};

Products products_of(const Hypotheses& all, const ColumnSums& sums, const VectorXd& weight,
                     std::size_t segment) {
  ActingColumns acting = acting_columns(all, sums, segment);
  const auto wide = static_cast<Index>(acting.at.size());
  MatrixXd x(weight.size(), wide);
  Index place = 0;
  for (const MatrixXd* part : acting.parts) {
    x.middleCols(place, part->cols()) = weight.asDiagonal() * *part;
    place += part->cols();
  }
  const VectorXd y = weight.cwiseProduct(all.parts.base.target[segment]);
  Products p{std::move(acting.at), MatrixXd::Zero(wide, wide), x.transpose() * y, y.squaredNorm(),
             static_cast<double>(y.size())};
  p.gram.selfadjointView<Eigen::Lower>().rankUpdate(x.transpose());
  return p;
}

/// Places ascend, so that the lower half stays the lower half.
void add_products(const Products& p, ColumnSums& sums) {
  for (std::size_t c = 0; c < p.at.size(); ++c)
    for (std::size_t r = c; r < p.at.size(); ++r)
      sums.gram(p.at[r], p.at[c]) += p.gram(static_cast<Index>(r), static_cast<Index>(c));
  sums.target(p.at) += p.target;
  sums.deviance += p.deviance;
  sums.rows += p.rows;
}

/// Squares of what was measured and of every column in one segment.
void add_energies(const Design& design, const Hypotheses& all, std::size_t segment,
                  ColumnSums& sums) {
  const auto s = static_cast<int>(segment);
  const int channel = design.segments()[segment].channel;
  const double samples = design.window(s).squaredNorm();
  VectorXd whole = design.target(s);
  if (const auto known = design.known(s, 0)) whole += *known;
  sums.measured(channel) += whole.squaredNorm();
  sums.samples(channel) += samples;
  Index first = 0;
  for (std::size_t i = 0; i < all.shapes.size(); ++i) {
    const MatrixXd& columns = all.shapes[i].columns[segment];
    if (columns.cols() > 0) {
      sums.energy.row(channel).segment(first, columns.cols()) += columns.colwise().squaredNorm();
      sums.acting.segment(first, columns.cols()).array() += samples;
    }
    first += sums.width[i];
  }
}

ColumnSums no_sums(const Design& design, const Hypotheses& all) {
  ColumnSums sums;
  for (const Term& term : all.parts.base.terms) sums.free += width_of(term.columns);
  for (const Shape& shape : all.shapes) sums.width.push_back(width_of(shape.columns));
  const Index own = std::accumulate(sums.width.begin(), sums.width.end(), Index{0});
  const Index channels = design.problem().channels;
  sums.gram = MatrixXd::Zero(sums.free + own, sums.free + own);
  sums.target = VectorXd::Zero(sums.free + own);
  sums.energy = MatrixXd::Zero(channels, own);
  sums.acting = VectorXd::Zero(own);
  sums.measured = sums.samples = VectorXd::Zero(channels);
  return sums;
}

}  // namespace

void ColumnSums::add(const ColumnSums& other) {
  if (free != other.free || width != other.width || measured.size() != other.measured.size())
    throw std::invalid_argument("sums of different columns do not add up");
  gram.triangularView<Eigen::Lower>() += other.gram;
  target += other.target;
  deviance += other.deviance;
  rows += other.rows;
  energy += other.energy;
  acting += other.acting;
  measured += other.measured;
  samples += other.samples;
}

ColumnSums column_sums(const Design& design, const Hypotheses& all, const Weights& weights) {
  ColumnSums sums = no_sums(design, all);
  std::vector<std::size_t> segments;
  for (std::size_t s = 0; s < weights.size(); ++s)
    if (weights[s].size() > 0) segments.push_back(s);
  // Added in their order, whichever is ready first: a sum's last bit depends on it.
  for (std::size_t from = 0; from < segments.size(); from += kAtOnce) {
    std::vector<Products> part(std::min(kAtOnce, segments.size() - from));
    tbb::parallel_for(std::size_t{0}, part.size(), [&](std::size_t i) {
      const std::size_t s = segments[from + i];
      part[i] = products_of(all, sums, weights[s], s);
    });
    for (const Products& p : part) add_products(p, sums);
  }
  for (const std::size_t s : segments) add_energies(design, all, s, sums);
  return sums;
}

}  // namespace sinew::diagnosis

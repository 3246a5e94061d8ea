// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/moments.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/pseudo_inverse.h"

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

/// How large a shape's coefficient is expected to be beside the others of its cause.
double expected_share(const Hypotheses& all, std::size_t shape, Index coefficient) {
  const Hypothesis& h = all.list[static_cast<std::size_t>(all.shapes[shape].hypothesis)];
  const auto p = static_cast<std::size_t>(coefficient);
  return p < h.source->linear.size() ? h.source->linear[p].share : 1.0;
}

/// The same as a multiple of the first coefficient, in the parameters' units.
double times_first(const Hypotheses& all, std::size_t shape, Index coefficient) {
  const Hypothesis& h = all.list[static_cast<std::size_t>(all.shapes[shape].hypothesis)];
  const auto p = static_cast<std::size_t>(coefficient);
  return p < h.source->linear.size() ? h.source->linear[p].times_first
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
    double of_first = std::numeric_limits<double>::infinity();
    for (Index c = 0; c < width; ++c) {
      if (!(energy(first + c) > 0.0)) continue;
      const std::size_t shape = m.of_shape.size() - 1;
      double scale = std::sqrt(sums.acting(first + c) / energy(first + c));
      if (c == 0) of_first = scale;
      if (std::isfinite(of_first)) scale = std::min(scale, of_first * times_first(all, shape, c));
      scales.push_back(std::min(scale * expected_share(all, shape, c),
                                known_spread(all, shape, c) / kLargestSize));
      at.push_back(sums.free + first + c);
      m.coefficient.push_back(static_cast<int>(c));
      ++m.of_shape.back().count;
    }
    first += width;
  }
  m.scale = VectorXd::Map(scales.data(), static_cast<Index>(scales.size()));
  return at;
}

/// Channels x columns, above zero where a column's hypothesis acts: its columns are looked at
/// together, so that all of them have one region, though one of a body's acts on fewer joints.
MatrixXd acting_together(const MatrixXd& energy, const Moments& m, const Hypotheses& all) {
  MatrixXd of_hypothesis = MatrixXd::Zero(energy.rows(), static_cast<Index>(all.list.size()));
  const auto each = [&](auto use) {
    for (std::size_t s = 0; s < all.shapes.size(); ++s) {
      const Moments::Range& range = m.of_shape[s];
      if (range.count > 0) use(range, static_cast<Index>(all.shapes[s].hypothesis));
    }
  };
  each([&](const Moments::Range& range, Index h) {
    of_hypothesis.col(h) += energy.middleCols(range.first, range.count).rowwise().sum();
  });
  MatrixXd acts(energy.rows(), energy.cols());
  each([&](const Moments::Range& range, Index h) {
    acts.middleCols(range.first, range.count) = of_hypothesis.col(h).replicate(1, range.count);
  });
  return acts;
}

/// Regions of the columns `at`: channels that share their noise are one, and those on which one
/// column of the free part acts, since all that it meets meets when it is taken out.
Regions regions_of(const ColumnSums& sums, const std::vector<Index>& at, const Moments& m,
                   const Hypotheses& all) {
  std::vector<Index> own;
  for (const Index column : at) own.push_back(column - sums.free);
  const MatrixXd acts = acting_together(sums.energy(Eigen::all, own), m, all);
  std::vector<std::vector<int>> joined = sums.joined;
  for (Index f = 0; f < sums.free; ++f) {
    VectorXd met = VectorXd::Zero(acts.rows());
    for (std::size_t c = 0; c < at.size(); ++c)
      if (sums.gram(at[c], f) != 0.0 &&
          (acts.col(static_cast<Index>(c)).array() > 0.0).count() == 1)
        met += acts.col(static_cast<Index>(c));
    joined.emplace_back();
    for (Index c = 0; c < met.size(); ++c)
      if (met(c) > 0.0) joined.back().push_back(static_cast<int>(c));
  }
  return Regions(acts, joined);
}

/// Scaled products of the columns `at` with the model's free part taken out.
RegionProducts products_of(const ColumnSums& sums, const std::vector<Index>& at, Regions regions,
                           const MatrixXd& cross, const MatrixXd& solved, const VectorXd& scale) {
  const auto of_sums = [&](const std::vector<Index>& columns) {
    std::vector<Index> list;
    list.reserve(columns.size());
    for (const Index c : columns) list.push_back(at[static_cast<std::size_t>(c)]);
    return list;
  };
  return RegionProducts(
      std::move(regions),
      [&](const std::vector<Index>& rows, const std::vector<Index>& columns) -> MatrixXd {
        MatrixXd product = sums.gram(of_sums(rows), of_sums(columns));
        product = VectorXd(scale(rows)).asDiagonal() * product;
        product *= VectorXd(scale(columns)).asDiagonal();
        if (sums.free > 0)
          product.noalias() -=
              MatrixXd(solved(rows, Eigen::all)) * MatrixXd(cross(columns, Eigen::all)).transpose();
        return product;
      });
}

/// -1/2 log det of a Gram matrix, of which columns that hardly differ are told apart by a share.
double log_volume(const MatrixXd& gram) {
  constexpr double told_apart = 1e-10;
  MatrixXd regular = gram;
  regular.diagonal() *= 1.0 + told_apart;
  regular.diagonal().array() += 1e-300;
  const Eigen::LDLT<MatrixXd> factor(regular);
  return -0.5 * factor.vectorD().cwiseMax(1e-300).array().log().sum();
}

/// The model's free part taken out of everything.
void project_out_free(const ColumnSums& sums, const std::vector<Index>& at, const Hypotheses& all,
                      Moments& m) {
  std::vector<Index> free(static_cast<std::size_t>(sums.free));
  std::iota(free.begin(), free.end(), Index{0});
  const VectorXd base_target = sums.target.head(sums.free);
  const MatrixXd cross = m.scale.asDiagonal() * sums.gram(at, free);
  const MatrixXd inverse = scaled_pseudo_inverse(sums.gram(free, free));
  const MatrixXd solved = cross * inverse;
  m.gram = products_of(sums, at, regions_of(sums, at, m, all), cross, solved, m.scale);
  m.target -= solved * base_target;
  m.deviance -= base_target.dot(inverse * base_target);
  m.rows -= static_cast<double>(sums.free);
  m.log_free_volume = log_volume(sums.gram(free, free));
}

}  // namespace

Moments moments_of(const ColumnSums& sums, const Hypotheses& all) {
  Moments m;
  const std::vector<Index> at = lay_out(sums, all, m);
  m.target = m.scale.cwiseProduct(VectorXd(sums.target(at)));
  m.deviance = sums.deviance;
  m.rows = sums.rows;
  project_out_free(sums, at, all, m);
  return m;
}

Moments moments_of(const Design& design, const Hypotheses& all, const Whitening& whitening) {
  return moments_of(column_sums(design, all, whitening), all);
}

}  // namespace sinew::diagnosis

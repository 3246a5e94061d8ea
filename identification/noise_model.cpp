// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/noise_model.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "identification/parallel_for.h"
#include "identification/spectrum.h"

namespace sinew {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Orthonormal basis of the columns' span, strongest directions first, at most `most` of them.
MatrixXd strongest_basis(MatrixXd columns, Index most) {
  for (Index c = 0; c < columns.cols(); ++c) {
    const double norm = columns.col(c).norm();
    if (norm > 0.0) columns.col(c) /= norm;
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(columns.transpose() * columns);
  const VectorXd& values = eigen.eigenvalues();  // ascending
  Index keep = 0;
  while (keep < std::min(most, values.size()) &&
         values(values.size() - 1 - keep) > 1e-7 * values(values.size() - 1))
    ++keep;
  return columns * (eigen.eigenvectors().rightCols(keep) *
                    values.tail(keep).cwiseSqrt().cwiseInverse().asDiagonal());
}

MatrixXd all_columns(const Model& model, const std::vector<const BandColumns*>& saturating,
                     std::size_t segment) {
  std::vector<const MatrixXd*> parts;
  for (const Term& term : model.terms) parts.push_back(&term.columns[segment]);
  for (const BandColumns* group : saturating) parts.push_back(&(*group)[segment]);
  Index wide = 0, rows = 0;
  for (const MatrixXd* part : parts) {
    wide += part->cols();
    rows = std::max(rows, part->rows());
  }
  MatrixXd all(rows, wide);
  Index at = 0;
  for (const MatrixXd* part : parts) {
    if (part->cols() == 0) continue;
    all.middleCols(at, part->cols()) = *part;
    at += part->cols();
  }
  return all;
}

/// Relative noise level over time: moving mean square of the whitened residual.
VectorXd level_over_time(const VectorXd& whitened_band, Index samples) {
  const VectorXd square = from_band(whitened_band, samples).col(0).array().square();
  const Index half = std::max<Index>(20, samples / 40);
  VectorXd level = smooth_ratio(square, VectorXd::Ones(samples), half, 0.0);
  const double mean = level.mean();
  return (level / mean).cwiseSqrt();
}

NoiseModel estimate_segment(const VectorXd& target, const MatrixXd& columns, Index samples) {
  const Index bins = target.size() / 2;
  NoiseModel noise;
  noise.variance = VectorXd::Ones(bins);
  VectorXd residual, leverage;
  // First with equal weights, then with the weights found: three rounds settle to a percent.
  for (int round = 0; round < 3; ++round) {
    const VectorXd weight = per_row(noise.variance.cwiseSqrt().cwiseInverse());
    const MatrixXd basis = strongest_basis(weight.asDiagonal() * columns, bins / 5);
    const VectorXd y = weight.cwiseProduct(target);
    residual = (y - basis * (basis.transpose() * y)).cwiseQuotient(weight);
    leverage = bin_energy(basis.rowwise().norm());
    noise.variance = noise_spectrum(residual, leverage);
  }
  const VectorXd whitened = residual.cwiseQuotient(per_row(noise.variance.cwiseSqrt()));
  const VectorXd energy = bin_energy(whitened);
  noise.leftover = VectorXd::Ones(bins);
  for (Index b = 1; b < bins; ++b)
    if (leverage(b) < 0.6) noise.leftover(b) = energy(b) / (2.0 - leverage(b));
  noise.envelope = level_over_time(whitened, samples);
  return noise;
}

}  // namespace

VectorXd noise_spectrum(const VectorXd& residual, const VectorXd& leverage) {
  const VectorXd energy = bin_energy(residual);
  VectorXd freedom = (2.0 - leverage.array()).max(0.05);
  freedom(0) = std::max(0.05, 1.0 - leverage(0));
  VectorXd variance = smooth_ratio(energy, freedom, 8, 0.12);
  // Without a floor, a quiet stretch of the spectrum would decide every fit.
  return variance.cwiseMax(1e-4 * variance.mean()).cwiseMax(1e-30);
}

std::vector<NoiseModel> estimate_noise(const Design& design, const Model& model,
                                       const std::vector<const BandColumns*>& saturating,
                                       int threads) {
  const std::vector<Segment>& segments = design.segments();
  std::vector<NoiseModel> noise(segments.size());
  parallel_for(static_cast<int>(segments.size()), threads, [&](int i) {
    const auto s = static_cast<std::size_t>(i);
    if (segments[s].holdout) return;
    noise[s] = estimate_segment(design.target(i, model.advance[s]),
                                all_columns(model, saturating, s), segments[s].samples);
  });
  return noise;
}

Weights whitening(const std::vector<NoiseModel>& noise) {
  Weights weights;
  for (const NoiseModel& model : noise)
    weights.push_back(model.variance.size() == 0
                          ? VectorXd()
                          : VectorXd(per_row(model.variance.cwiseSqrt().cwiseInverse())));
  return weights;
}

double repeat_noise_floor(const VectorXd& first, const VectorXd& second) {
  if (first.size() != second.size() || first.size() == 0)
    throw std::invalid_argument("repeat_noise_floor: runs of different length");
  return 0.5 * (first - second).squaredNorm() / static_cast<double>(first.size());
}

}  // namespace sinew

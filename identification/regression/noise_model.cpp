// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/noise_model.h"

#include <tbb/parallel_for.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Full whitening lets the quiet end of the spectrum decide every fit, and there a model that is
// only nearly right is wrong. With this share of the mean added, no frequency counts for more
// than a few times its part in the error one sees.
constexpr double kDamping = 1.0;

/// Orthonormal basis of the columns' span, strongest directions first, at most `most` of them. Each
/// column has length 1.
MatrixXd strongest_basis(const MatrixXd& columns, Index most) {
  MatrixXd gram = MatrixXd::Zero(columns.cols(), columns.cols());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);  // reads the lower half
  const VectorXd& values = eigen.eigenvalues();               // ascending
  Index keep = 0;
  while (keep < std::min(most, values.size()) &&
         values(values.size() - 1 - keep) > 1e-7 * values(values.size() - 1))
    ++keep;
  return columns * (eigen.eigenvectors().rightCols(keep) *
                    values.tail(keep).cwiseSqrt().cwiseInverse().asDiagonal());
}

/// All columns that act in a segment and are not zero, each of length 1.
MatrixXd all_columns(const Model& model, const std::vector<const LibraryColumns*>& saturating,
                     std::size_t segment) {
  Index wide = 0;
  for (const Term& term : model.terms) wide += term.columns[segment].cols();
  for (const LibraryColumns* group : saturating) wide += (*group)[segment].cols();
  MatrixXd all(model.target[segment].size(), wide);
  Index kept = 0;
  const auto add = [&](const auto& column) {
    all.col(kept) = column;
    const double norm = all.col(kept).norm();
    if (norm > 0.0) all.col(kept++) /= norm;
  };
  for (const Term& term : model.terms)
    for (const auto& column : term.columns[segment].colwise()) add(column);
  for (const LibraryColumns* group : saturating)
    for (const auto& column : (*group)[segment].colwise()) add(column.cast<double>());
  all.conservativeResize(Eigen::NoChange, kept);
  return all;
}

/// Noise level per sample from the whitened residual: moving mean square over a quarter second,
/// drawn to its mean so that chance fluctuations of few samples do not become a pattern. What a
/// sample says counts by `seen`, 0 to 1.
VectorXd level_over_time(const VectorXd& whitened, const VectorXd& leverage, const VectorXd& seen,
                         double rate_hz) {
  const auto half = std::max<Index>(4, static_cast<Index>(0.125 * rate_hz));
  const VectorXd square = whitened.cwiseAbs2() / (whitened.squaredNorm() / seen.sum());
  const VectorXd freedom = (seen - leverage).cwiseMax(0.2 * seen).cwiseMax(1e-9);
  const VectorXd local = smooth_ratio(square, freedom, half, 0.0);
  const VectorXd own = static_cast<double>(2 * half + 1) *
                       smooth_ratio(seen, VectorXd::Ones(seen.size()), half, 0.0);
  const double prior = 25.0;
  const VectorXd level = (own.array() * local.array() + prior) / (own.array() + prior);
  return (level / level.mean()).cwiseSqrt();
}

/// Energy per bin of an orthonormal basis, and per sample.
struct Leverage {
  VectorXd bins, samples;
};

Leverage leverage_of(const MatrixXd& band_basis, Index samples) {
  const Index bins = band_basis.rows() / 2;
  Leverage leverage{VectorXd::Zero(bins), from_band(band_basis, samples).rowwise().squaredNorm()};
  for (Index c = 0; c < band_basis.cols(); ++c) leverage.bins += bin_energy(band_basis.col(c));
  return leverage;
}

/// What the weights are made of: the spectrum plus a share of its mean.
VectorXd damped(const VectorXd& variance) {
  return variance.array() + kDamping * variance.mean();
}

/// The residual is that of an unweighted fit: weights taken from the residual of a fit with those
/// weights run away where the model is wrong (what is badly fitted counts less and less).
NoiseModel estimate_segment(const VectorXd& target, const MatrixXd& columns, const Segment& segment,
                            const VectorXd& window) {
  const Index bins = segment.bins;
  const VectorXd seen = window.cwiseAbs2();
  const double share = seen.mean();
  NoiseModel noise;
  // A model without free terms has nothing to take out.
  const MatrixXd basis =
      columns.cols() == 0 ? MatrixXd(target.size(), 0) : strongest_basis(columns, bins / 5);
  const VectorXd residual = target - basis * (basis.transpose() * target);
  const Leverage leverage = leverage_of(basis, segment.samples);
  noise.variance = noise_spectrum(residual, leverage.bins, share);
  const VectorXd energy = bin_energy(residual).cwiseQuotient(damped(noise.variance));
  noise.leftover = 2.0 * noise.variance.cwiseQuotient(damped(noise.variance));
  for (Index b = 1; b < bins; ++b)
    if (leverage.bins(b) < 0.6 * share)
      noise.leftover(b) = 2.0 * energy(b) / (2.0 * share - leverage.bins(b));
  const VectorXd even = residual.cwiseQuotient(per_row(noise.variance.cwiseSqrt()));
  noise.level =
      level_over_time(from_band(even, segment.samples), leverage.samples, seen, segment.rate_hz);
  return noise;
}

}  // namespace

VectorXd noise_spectrum(const VectorXd& residual, const VectorXd& leverage, double share) {
  const VectorXd energy = bin_energy(residual);
  VectorXd freedom = (2.0 * share - leverage.array()).max(0.05 * share);
  freedom(0) = std::max(0.05 * share, share - leverage(0));
  // Never zero: a noise-free target must not divide by it.
  return smooth_ratio(energy, freedom, 8, 0.12).cwiseMax(1e-30);
}

std::vector<NoiseModel> estimate_noise(const Design& design, const Model& model,
                                       const std::vector<const LibraryColumns*>& saturating) {
  const std::vector<Segment>& segments = design.segments();
  std::vector<NoiseModel> noise(segments.size());
  tbb::parallel_for(0, static_cast<int>(segments.size()), [&](int i) {
    const auto s = static_cast<std::size_t>(i);
    if (segments[s].holdout) return;
    noise[s] = estimate_segment(model.target[s], all_columns(model, saturating, s), segments[s],
                                design.window(i));
  });
  return noise;
}

Weights whitening(const std::vector<NoiseModel>& noise) {
  Weights weights;
  for (const NoiseModel& model : noise)
    weights.push_back(model.variance.size() == 0
                          ? VectorXd()
                          : VectorXd(per_row(damped(model.variance).cwiseSqrt().cwiseInverse())));
  return weights;
}

double repeat_noise_floor(const VectorXd& first, const VectorXd& second) {
  if (first.size() != second.size() || first.size() == 0)
    throw std::invalid_argument("repeat_noise_floor: runs of different length");
  return 0.5 * (first - second).squaredNorm() / static_cast<double>(first.size());
}

}  // namespace sinew::diagnosis

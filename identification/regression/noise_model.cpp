// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/noise_model.h"

#include <tbb/parallel_for.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

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
MatrixXd all_columns(const Model& model, std::size_t segment) {
  Index wide = 0;
  for (const Term& term : model.terms) wide += term.columns[segment].cols();
  MatrixXd all(model.target[segment].size(), wide);
  Index kept = 0;
  for (const Term& term : model.terms)
    for (const auto& column : term.columns[segment].colwise()) {
      all.col(kept) = column;
      const double norm = all.col(kept).norm();
      if (norm > 0.0) all.col(kept++) /= norm;
    }
  all.conservativeResize(Eigen::NoChange, kept);
  return all;
}

/// Energy per bin of an orthonormal basis.
VectorXd leverage_of(const MatrixXd& band_basis) {
  VectorXd leverage = VectorXd::Zero(band_basis.rows() / 2);
  for (Index c = 0; c < band_basis.cols(); ++c) leverage += bin_energy(band_basis.col(c));
  return leverage;
}

/// What the weights are made of: the spectrum plus a share of its mean.
VectorXd damped(const VectorXd& variance) {
  return variance.array() + kDamping * variance.mean();
}

/// The residual is that of an unweighted fit: weights taken from the residual of a fit with those
/// weights run away where the model is wrong (what is badly fitted counts less and less).
NoiseModel estimate_segment(const VectorXd& target, const MatrixXd& columns, Index bins,
                            const VectorXd& window) {
  // A model without free terms has nothing to take out.
  const MatrixXd basis =
      columns.cols() == 0 ? MatrixXd(target.size(), 0) : strongest_basis(columns, bins / 5);
  const VectorXd residual = target - basis * (basis.transpose() * target);
  return {noise_spectrum(residual, leverage_of(basis), window.cwiseAbs2().mean())};
}

}  // namespace

VectorXd noise_spectrum(const VectorXd& residual, const VectorXd& leverage, double share) {
  const VectorXd energy = bin_energy(residual);
  VectorXd freedom = (2.0 * share - leverage.array()).max(0.05 * share);
  freedom(0) = std::max(0.05 * share, share - leverage(0));
  // Never zero: a noise-free target must not divide by it.
  return smooth_ratio(energy, freedom, 8, 0.12).cwiseMax(1e-30);
}

Weights whitening(const std::vector<NoiseModel>& noise) {
  Weights weights;
  for (const NoiseModel& model : noise)
    weights.push_back(model.variance.size() == 0
                          ? VectorXd()
                          : VectorXd(per_row(damped(model.variance).cwiseSqrt().cwiseInverse())));
  return weights;
}

NoiseView own_noise(const Design& design, const Model& model) {
  const std::vector<Segment>& segments = design.segments();
  NoiseView view;
  view.noise.resize(segments.size());
  tbb::parallel_for(0, static_cast<int>(segments.size()), [&](int i) {
    const auto s = static_cast<std::size_t>(i);
    if (segments[s].holdout) return;
    view.noise[s] = estimate_segment(model.target[s], all_columns(model, s), segments[s].bins,
                                     design.window(i));
  });
  view.weights = whitening(view.noise);
  return view;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/noise_spectrum_fit.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/linear_fit.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A saturated fit leaves at least this share of the rows to the noise.
constexpr double kRowsLeft = 0.7;

/// Shapes that stand for their hypothesis: one, or two where there are more than two.
std::vector<int> representatives(const Hypotheses& all) {
  std::vector<int> chosen;
  for (const Hypothesis& h : all.list) {
    const std::size_t count = h.shapes.size();
    if (count == 0) continue;
    chosen.push_back(h.shapes[count / 3]);
    if (count > 2) chosen.push_back(h.shapes[2 * count / 3]);
  }
  return chosen;
}

/// Those of some columns that act in a segment, whitened, each of length 1.
MatrixXd whitened_columns(const std::vector<const BandColumns*>& columns, std::size_t segment,
                          const VectorXd& weight) {
  std::vector<const MatrixXd*> parts;
  for (const BandColumns* part : columns) parts.push_back(&(*part)[segment]);
  Index wide = 0;
  for (const MatrixXd* part : parts) wide += part->cols();
  MatrixXd x(weight.size(), wide);
  Index kept = 0;
  for (const MatrixXd* part : parts)
    for (Index c = 0; c < part->cols(); ++c) {
      x.col(kept) = weight.cwiseProduct(part->col(c));
      const double norm = x.col(kept).norm();
      if (norm > 0.0) x.col(kept++) /= norm;
    }
  return x.leftCols(kept);
}

/// Orthonormal basis of the span, strongest directions first, as far as rows are left over.
MatrixXd basis_of(const MatrixXd& x) {
  if (x.cols() == 0) return x;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(x.transpose() * x);
  const VectorXd& values = eigen.eigenvalues();
  const auto most = static_cast<Index>((1.0 - kRowsLeft) * static_cast<double>(x.rows()));
  Index keep = 0;
  while (keep < std::min(most, values.size()) &&
         values(values.size() - 1 - keep) > 1e-7 * values(values.size() - 1))
    ++keep;
  return x * (eigen.eigenvectors().rightCols(keep) *
              values.tail(keep).cwiseSqrt().cwiseInverse().asDiagonal());
}

/// Of a segment's weighted rows what a fit leaves, and the share that it has taken of each.
struct FittedRows {
  VectorXd left, leverage;
};

/// A segment by itself, as far as rows are left over.
FittedRows fitted_alone(const std::vector<const BandColumns*>& columns, std::size_t segment,
                        const VectorXd& target, const VectorXd& weight) {
  const MatrixXd basis = basis_of(whitened_columns(columns, segment, weight));
  const VectorXd white = weight.cwiseProduct(target);
  return {white - basis * (basis.transpose() * white), basis.rowwise().squaredNorm()};
}

/// All training segments together: what they share takes no more of all of them than one row.
std::vector<FittedRows> fitted_together(const Model& model, const Weights& weights) {
  const Stack rows = stack(model, weights);
  const LinearFit fit = solve(rows);
  std::vector<FittedRows> all(rows.a.size());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t s) {
    const MatrixXd& a = rows.a[s];
    all[s].left = fit.residual.segment(rows.first_row[s], a.rows());
    all[s].leverage = VectorXd::Zero(a.rows());
    if (rows.at[s].empty()) return;
    const MatrixXd covariance = fit.covariance(rows.at[s], rows.at[s]);
    all[s].leverage = (a * covariance).cwiseProduct(a).rowwise().sum();
  });
  return all;
}

/// What is left of a segment's target, unwhitened, and what the fit took of every bin.
std::vector<BinEnergy> bins_of(const Design& design, std::size_t s, const FittedRows& rows,
                               const VectorXd& weight) {
  const Segment& segment = design.segments()[s];
  const double share =
      design.window(static_cast<int>(s)).squaredNorm() / static_cast<double>(segment.samples);
  const VectorXd left = bin_energy(VectorXd(rows.left.cwiseQuotient(weight)));
  const VectorXd leverage = bin_energy(VectorXd(rows.leverage.cwiseMax(0.0).cwiseSqrt()));
  std::vector<BinEnergy> bins;
  for (Index b = 0; b < segment.bins; ++b) {
    const double of_bin = (b == 0 ? 1.0 : 2.0) * share;
    const double freedom = of_bin - leverage(b);
    if (freedom < 0.1 * of_bin) continue;  // next to nothing is left there
    bins.push_back({segment.rate_hz * static_cast<double>(b) / static_cast<double>(segment.samples),
                    left(b), freedom});
  }
  return bins;
}

/// What is expected of a channel at a frequency.
double expected_at(const ExpectedSpectra& expected, int channel, double frequency_hz) {
  const auto c = static_cast<std::size_t>(channel);
  return c < expected.of_channel.size() ? expected.of_channel[c].at(frequency_hz) : 1.0;
}

VectorXd weight_of(const Design& design, std::size_t s, const SmoothSpectrum& spectrum,
                   const ExpectedSpectra& expected, double floor) {
  const Segment& segment = design.segments()[s];
  const double floor_per_row =
      floor * static_cast<double>(segment.samples) / (2.0 * static_cast<double>(segment.bins));
  VectorXd weight(segment.bins);
  for (Index b = 0; b < segment.bins; ++b) {
    const double frequency =
        segment.rate_hz * static_cast<double>(b) / static_cast<double>(segment.samples);
    weight(b) =
        1.0 / std::sqrt(spectrum.at(frequency) * expected_at(expected, segment.channel, frequency) +
                        floor_per_row);
  }
  return per_row(weight);
}

/// One channel's spectrum, and the weights of its segments.
void whiten(const Design& design, int channel, const std::vector<std::vector<BinEnergy>>& bins,
            const ExpectedSpectra& expected, bool rises_go_on, double floor, Whitening& whitening) {
  std::vector<BinEnergy> own;
  double band = 0.0;
  for (std::size_t s = 0; s < bins.size(); ++s)
    if (design.segments()[s].channel == channel) {
      own.insert(own.end(), bins[s].begin(), bins[s].end());
      band = std::max(band, design.segments()[s].filter.band_hz);
    }
  if (own.empty()) return;
  for (BinEnergy& bin : own) bin.energy /= expected_at(expected, channel, bin.frequency_hz);
  const SmoothSpectrum spectrum = fit_spectrum(own, band, {expected.rows, rises_go_on});
  whitening.of_channel[static_cast<std::size_t>(channel)] = spectrum;
  for (std::size_t s = 0; s < bins.size(); ++s)
    if (design.segments()[s].channel == channel)
      (design.segments()[s].holdout ? whitening.held_out : whitening.training)[s] =
          weight_of(design, s, spectrum, expected, floor);
}

/// Training segments of the same log and length whose channels share their noise, and how far the
/// rows that a fit leaves go together.
std::vector<SharedNoise> shared_noise(const Design& design, const std::vector<FittedRows>& rows) {
  const Problem& problem = design.problem();
  std::vector<SharedNoise> all;
  if (problem.noise_groups.empty()) return all;
  std::map<std::tuple<int, int, Index>, std::vector<std::size_t>> groups;
  for (std::size_t s = 0; s < rows.size(); ++s) {
    const Segment& segment = design.segments()[s];
    if (rows[s].left.size() > 0)
      groups[{segment.recording, problem.noise_groups[static_cast<std::size_t>(segment.channel)],
              rows[s].left.size()}]
          .push_back(s);
  }
  for (auto& [key, segments] : groups) {
    const auto count = static_cast<Index>(segments.size());
    if (count < 2) continue;
    MatrixXd left(std::get<Index>(key), count);
    for (Index i = 0; i < count; ++i)
      left.col(i) = rows[segments[static_cast<std::size_t>(i)]].left;
    const VectorXd size = left.colwise().norm().cwiseMax(1e-300).cwiseInverse();
    all.push_back(
        {std::move(segments), size.asDiagonal() * (left.transpose() * left) * size.asDiagonal()});
  }
  return all;
}

/// What a spectrum is fitted with, beside what is left over.
struct SpectraPrior {
  const VectorXd& floor;
  const ExpectedSpectra& expected;
  bool rises_go_on = false;
};

/// From what `fitted` leaves over under given weights.
template <class FittedUnder>
Whitening whitening_from(const Design& design, Weights weights, const FittedUnder& fitted,
                         const SpectraPrior& prior) {
  const auto count = design.segments().size();
  Whitening whitening{std::move(weights), Weights(count), {}, {}, {}};
  whitening.of_channel.resize(static_cast<std::size_t>(design.problem().channels));
  std::vector<FittedRows> rows;
  // The second fit is weighted with the first one's spectrum.
  for (int round = 0; round < 2; ++round) {
    rows = fitted(whitening.training);
    std::vector<std::vector<BinEnergy>> bins(count);
    for (std::size_t s = 0; s < count; ++s)
      if (!design.segments()[s].holdout)
        bins[s] = bins_of(design, s, rows[s], whitening.training[s]);
    for (int channel = 0; channel < design.problem().channels; ++channel)
      whiten(design, channel, bins, prior.expected, prior.rises_go_on, prior.floor(channel),
             whitening);
  }
  whitening.shared = shared_noise(design, rows);
  return whitening;
}

/// A channel's rows in units of what is to be fitted in it.
Weights weights_by_size(const Design& design, const std::vector<VectorXd>& target) {
  const auto channels = static_cast<Index>(design.problem().channels);
  VectorXd energy = VectorXd::Zero(channels), rows = VectorXd::Zero(channels);
  for (std::size_t s = 0; s < target.size(); ++s)
    if (!design.segments()[s].holdout) {
      energy(design.segments()[s].channel) += target[s].squaredNorm();
      rows(design.segments()[s].channel) += static_cast<double>(target[s].size());
    }
  Weights weights = even_weights(design);
  for (std::size_t s = 0; s < target.size(); ++s) {
    const int channel = design.segments()[s].channel;
    if (energy(channel) > 0.0) weights[s] *= std::sqrt(rows(channel) / energy(channel));
  }
  return weights;
}

}  // namespace

Whitening whitening_of(const Design& design, const Hypotheses& all, const VectorXd& floor,
                       const ExpectedSpectra& expected) {
  std::vector<const BandColumns*> columns;
  for (const Term& term : all.parts.base.terms) columns.push_back(&term.columns.get());
  for (const int shape : representatives(all))
    columns.push_back(&all.shapes[static_cast<std::size_t>(shape)].columns);
  const auto fitted = [&](const Weights& weights) {
    std::vector<FittedRows> rows(weights.size());
    tbb::parallel_for(std::size_t{0}, rows.size(), [&](std::size_t s) {
      if (weights[s].size() > 0)
        rows[s] = fitted_alone(columns, s, all.parts.base.target[s], weights[s]);
    });
    return rows;
  };
  return whitening_from(design, even_weights(design), fitted, {floor, expected, false});
}

Whitening whitening_beside(const Design& design, const Model& model, const VectorXd& floor) {
  const auto fitted = [&](const Weights& weights) { return fitted_together(model, weights); };
  return whitening_from(design, weights_by_size(design, model.target), fitted, {floor, {}, true});
}

double log_determinant(const Whitening& whitening) {
  double sum = 0.0;
  for (const VectorXd& weight : whitening.training)
    if (weight.size() > 0) sum += weight.array().log().sum();
  for (const SharedNoise& group : whitening.shared) {
    MatrixXd correlation = group.correlation;
    correlation.diagonal().setConstant(1.0 + 1e-9);
    const Eigen::LLT<MatrixXd> factor(correlation);
    const auto rows = static_cast<double>(whitening.training[group.segments.front()].size());
    sum -= rows * MatrixXd(factor.matrixL()).diagonal().array().log().sum();
  }
  return sum;
}

}  // namespace sinew::diagnosis

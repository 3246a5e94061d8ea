// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/noise_spectrum_fit.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "identification/likelihood/decision_constants.h"
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

/// What a fit leaves of a weighted target.
VectorXd left_of(const VectorXd& target, const MatrixXd& basis, const VectorXd& weight) {
  const VectorXd white = weight.cwiseProduct(target);
  return white - basis * (basis.transpose() * white);
}

/// What is left of a segment's target, unwhitened, and what the fit took of every bin.
std::vector<BinEnergy> bins_of(const Design& design, std::size_t s, const VectorXd& residual,
                               const MatrixXd& basis, const VectorXd& weight) {
  const Segment& segment = design.segments()[s];
  const double share =
      design.window(static_cast<int>(s)).squaredNorm() / static_cast<double>(segment.samples);
  const VectorXd left = bin_energy(VectorXd(residual.cwiseQuotient(weight)));
  VectorXd leverage = VectorXd::Zero(segment.bins);
  for (Index c = 0; c < basis.cols(); ++c) leverage += bin_energy(basis.col(c));
  std::vector<BinEnergy> bins;
  for (Index b = 0; b < segment.bins; ++b) {
    const double rows = (b == 0 ? 1.0 : 2.0) * share;
    const double freedom = rows - leverage(b);
    if (freedom < 0.1 * rows) continue;  // next to nothing is left there
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
std::vector<SharedNoise> shared_noise(const Design& design, const std::vector<VectorXd>& left) {
  const Problem& problem = design.problem();
  std::vector<SharedNoise> all;
  if (problem.noise_groups.empty()) return all;
  std::map<std::tuple<int, int, Index>, std::vector<std::size_t>> groups;
  for (std::size_t s = 0; s < left.size(); ++s) {
    const Segment& segment = design.segments()[s];
    if (left[s].size() > 0)
      groups[{segment.recording, problem.noise_groups[static_cast<std::size_t>(segment.channel)],
              left[s].size()}]
          .push_back(s);
  }
  for (auto& [key, segments] : groups) {
    const auto count = static_cast<Index>(segments.size());
    if (count < 2) continue;
    MatrixXd rows(std::get<Index>(key), count);
    for (Index i = 0; i < count; ++i) rows.col(i) = left[segments[static_cast<std::size_t>(i)]];
    const VectorXd size = rows.colwise().norm().cwiseMax(1e-300).cwiseInverse();
    all.push_back(
        {std::move(segments), size.asDiagonal() * (rows.transpose() * rows) * size.asDiagonal()});
  }
  return all;
}

/// From what a fit of a target by some columns leaves over.
Whitening whitening_from(const Design& design, const std::vector<VectorXd>& target,
                         const std::vector<const BandColumns*>& fitted, const VectorXd& floor,
                         const ExpectedSpectra& expected, bool rises_go_on) {
  const auto count = design.segments().size();
  Whitening whitening{even_weights(design), Weights(count), {}, {}, {}};
  whitening.of_channel.resize(static_cast<std::size_t>(design.problem().channels));
  Weights& weights = whitening.training;
  std::vector<VectorXd> left(count);
  // The second fit is weighted with the first one's spectrum.
  for (int round = 0; round < 2; ++round) {
    std::vector<std::vector<BinEnergy>> bins(count);
    tbb::parallel_for(0, static_cast<int>(count), [&](int i) {
      const auto s = static_cast<std::size_t>(i);
      if (design.segments()[s].holdout) return;
      const MatrixXd basis = basis_of(whitened_columns(fitted, s, weights[s]));
      left[s] = left_of(target[s], basis, weights[s]);
      bins[s] = bins_of(design, s, left[s], basis, weights[s]);
    });
    for (int channel = 0; channel < design.problem().channels; ++channel)
      whiten(design, channel, bins, expected, rises_go_on, floor(channel), whitening);
  }
  whitening.shared = shared_noise(design, left);
  return whitening;
}

}  // namespace

Whitening whitening_of(const Design& design, const Hypotheses& all, const VectorXd& floor,
                       const ExpectedSpectra& expected) {
  std::vector<const BandColumns*> fitted;
  for (const Term& term : all.parts.base.terms) fitted.push_back(&term.columns.get());
  for (const int shape : representatives(all))
    fitted.push_back(&all.shapes[static_cast<std::size_t>(shape)].columns);
  return whitening_from(design, all.parts.base.target, fitted, floor, expected, false);
}

Whitening whitening_beside(const Design& design, const Model& model, const VectorXd& floor) {
  std::vector<const BandColumns*> fitted;
  for (const Term& term : model.terms) fitted.push_back(&term.columns.get());
  return whitening_from(design, model.target, fitted, floor, {}, true);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/noise_spectrum_fit.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A saturated fit leaves at least this share of the rows to the noise.
constexpr double kRowsLeft = 0.7;

VectorXd cosines_at(double frequency_hz, double band_hz) {
  VectorXd x(kCosines + 1);
  for (int j = 0; j <= kCosines; ++j)
    x(j) = std::cos(std::numbers::pi * j * frequency_hz / band_hz);
  return x;
}

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

/// Everything that acts in a segment, whitened, each column of length 1.
MatrixXd saturated(const Hypotheses& all, const std::vector<int>& shapes, std::size_t segment,
                   const VectorXd& weight) {
  std::vector<const MatrixXd*> parts;
  for (const Term& term : all.parts.base.terms) parts.push_back(&term.columns[segment]);
  for (const int shape : shapes)
    parts.push_back(&all.shapes[static_cast<std::size_t>(shape)].columns[segment]);
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

/// What is left of a segment's target, unwhitened, and what the fit took of every bin.
std::vector<BinEnergy> bins_of(const Design& design, std::size_t s, const VectorXd& target,
                               const MatrixXd& basis, const VectorXd& weight) {
  const Segment& segment = design.segments()[s];
  const double share =
      design.window(static_cast<int>(s)).squaredNorm() / static_cast<double>(segment.samples);
  const VectorXd white = weight.cwiseProduct(target);
  const VectorXd left =
      bin_energy(VectorXd((white - basis * (basis.transpose() * white)).cwiseQuotient(weight)));
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
            const ExpectedSpectra& expected, double floor, Whitening& whitening) {
  std::vector<BinEnergy> own;
  double band = 0.0;
  for (std::size_t s = 0; s < bins.size(); ++s)
    if (design.segments()[s].channel == channel) {
      own.insert(own.end(), bins[s].begin(), bins[s].end());
      band = std::max(band, design.segments()[s].filter.band_hz);
    }
  if (own.empty()) return;
  for (BinEnergy& bin : own) bin.energy /= expected_at(expected, channel, bin.frequency_hz);
  const SmoothSpectrum spectrum = fit_spectrum(own, band, expected.rows);
  whitening.of_channel[static_cast<std::size_t>(channel)] = spectrum;
  for (std::size_t s = 0; s < bins.size(); ++s)
    if (design.segments()[s].channel == channel)
      (design.segments()[s].holdout ? whitening.held_out : whitening.training)[s] =
          weight_of(design, s, spectrum, expected, floor);
}

}  // namespace

double SmoothSpectrum::at(double frequency_hz) const {
  return std::exp(cosines_at(std::min(frequency_hz, band_hz), band_hz).dot(cosines));
}

SmoothSpectrum fit_spectrum(const std::vector<BinEnergy>& bins, double band_hz, double flat_rows) {
  // A cosine's square is a half in the mean.
  VectorXd prior = VectorXd::Constant(kCosines + 1, 0.5 * flat_rows);
  prior(0) = 0.0;
  SmoothSpectrum spectrum{VectorXd::Zero(kCosines + 1), band_hz};
  double energy = 1e-300, freedom = 1e-300;
  for (const BinEnergy& bin : bins) {
    energy += bin.energy;
    freedom += bin.freedom;
  }
  spectrum.cosines(0) = std::log(energy / freedom);
  constexpr int most_steps = 60;
  for (int step = 0; step < most_steps; ++step) {
    VectorXd slope = -prior.cwiseProduct(spectrum.cosines);
    MatrixXd curvature = prior.asDiagonal();
    curvature.diagonal().array() += 1e-9;
    for (const BinEnergy& bin : bins) {
      const VectorXd x = cosines_at(bin.frequency_hz, band_hz);
      const double ratio =
          std::min(bin.energy / std::exp(x.dot(spectrum.cosines)), kClipped * bin.freedom);
      slope += (ratio - bin.freedom) * x;
      curvature += bin.freedom * x * x.transpose();
    }
    VectorXd move = curvature.ldlt().solve(slope);
    // Fisher's steps overshoot far from the maximum.
    move *= std::min(1.0, 1.0 / std::max(1e-12, move.cwiseAbs().maxCoeff()));
    spectrum.cosines += move;
    if (move.cwiseAbs().maxCoeff() < 1e-4) break;
  }
  return spectrum;
}

Whitening whitening_of(const Design& design, const Hypotheses& all, const VectorXd& floor,
                       const ExpectedSpectra& expected) {
  const std::vector<int> shapes = representatives(all);
  const auto count = design.segments().size();
  Whitening whitening{even_weights(design), Weights(count), {}};
  whitening.of_channel.resize(static_cast<std::size_t>(design.problem().channels));
  Weights& weights = whitening.training;
  // The second fit is weighted with the first one's spectrum.
  for (int round = 0; round < 2; ++round) {
    std::vector<std::vector<BinEnergy>> bins(count);
    tbb::parallel_for(0, static_cast<int>(count), [&](int i) {
      const auto s = static_cast<std::size_t>(i);
      if (design.segments()[s].holdout) return;
      bins[s] = bins_of(design, s, all.parts.base.target[s],
                        basis_of(saturated(all, shapes, s, weights[s])), weights[s]);
    });
    for (int channel = 0; channel < design.problem().channels; ++channel)
      whiten(design, channel, bins, expected, floor(channel), whitening);
  }
  return whitening;
}

}  // namespace sinew::diagnosis

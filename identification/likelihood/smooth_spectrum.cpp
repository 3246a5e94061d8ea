// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/smooth_spectrum.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "identification/likelihood/decision_constants.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Stretches of frequencies in each of which a slow disturbance may rise: from the slowest that a
// log of some ten seconds tells from its mean to what cosines over the band resolve, by half
// decades.
constexpr double kStretchesHz[] = {0.3, 1.0, 3.0, 10.0};
constexpr Index kRises = static_cast<Index>(std::size(kStretchesHz)) - 1;
constexpr Index kFirstRise = kCosines + 1, kCoefficients = kFirstRise + kRises;

/// The cosines and the rises. All rises by 1: a disturbance of first order, whose corner is at the
/// lowest frequency.
VectorXd basis_at(double frequency_hz, double band_hz) {
  VectorXd x(kCoefficients);
  for (int j = 0; j <= kCosines; ++j)
    x(j) = std::cos(std::numbers::pi * j * frequency_hz / band_hz);
  const double f = frequency_hz * frequency_hz;
  for (Index k = 0; k < kRises; ++k) {
    const double low = kStretchesHz[k], high = kStretchesHz[k + 1];
    x(kFirstRise + k) = std::log((f + high * high) / (f + low * low));
  }
  return x;
}

/// Precision of what is known of the coefficients beforehand.
MatrixXd prior_precision(const SpectrumPrior& prior) {
  MatrixXd precision = MatrixXd::Zero(kCoefficients, kCoefficients);
  // A cosine's square is a half in the mean.
  precision.diagonal().tail(kCoefficients - 1).setConstant(0.5 * prior.flat_rows);
  precision.diagonal().array() += 1e-9;
  // Of a rise from the one beside it, or from none at all.
  constexpr double differ_by = 0.5;
  for (Index k = kFirstRise; k < kCoefficients - (prior.rises_go_on ? 1 : 0); ++k) {
    VectorXd difference = VectorXd::Zero(kCoefficients);
    difference(k) = 1.0 / differ_by;
    if (prior.rises_go_on) difference(k + 1) = -1.0 / differ_by;
    precision += 2.0 * difference * difference.transpose();
  }
  return precision;
}

/// Slope and curvature of the logarithm of the likelihood and the prior.
struct Score {
  VectorXd slope;
  MatrixXd curvature;
};

Score score_of(const SmoothSpectrum& spectrum, const std::vector<BinEnergy>& bins,
               const MatrixXd& prior) {
  Score score{-prior * spectrum.coefficients, prior};
  for (const BinEnergy& bin : bins) {
    const VectorXd x = basis_at(bin.frequency_hz, spectrum.band_hz);
    const double ratio =
        std::min(bin.energy / std::exp(x.dot(spectrum.coefficients)), kClipped * bin.freedom);
    score.slope += (ratio - bin.freedom) * x;
    score.curvature += bin.freedom * x * x.transpose();
  }
  return score;
}

/// A rise at a limit stays there where the score points beyond it.
void hold_at_limits(const SmoothSpectrum& spectrum, Score& score) {
  for (Index k = kFirstRise; k < kCoefficients; ++k) {
    const double at = spectrum.coefficients(k);
    if (!(at <= 0.0 && score.slope(k) < 0.0) && !(at >= 1.0 && score.slope(k) > 0.0)) continue;
    score.slope(k) = 0.0;
    score.curvature.row(k).setZero();
    score.curvature.col(k).setZero();
    score.curvature(k, k) = 1.0;
  }
}

}  // namespace

double SmoothSpectrum::at(double frequency_hz) const {
  return std::exp(basis_at(std::min(frequency_hz, band_hz), band_hz).dot(coefficients));
}

// Fisher scoring.
SmoothSpectrum fit_spectrum(const std::vector<BinEnergy>& bins, double band_hz,
                            const SpectrumPrior& expected) {
  const MatrixXd prior = prior_precision(expected);
  SmoothSpectrum spectrum{VectorXd::Zero(kCoefficients), band_hz};
  double energy = 1e-300, freedom = 1e-300;
  for (const BinEnergy& bin : bins) {
    energy += bin.energy;
    freedom += bin.freedom;
  }
  spectrum.coefficients(0) = std::log(energy / freedom);
  constexpr int most_steps = 60;
  for (int step = 0; step < most_steps; ++step) {
    Score score = score_of(spectrum, bins, prior);
    hold_at_limits(spectrum, score);
    VectorXd move = score.curvature.ldlt().solve(score.slope);
    // Fisher's steps overshoot far from the maximum.
    move *= std::min(1.0, 1.0 / std::max(1e-12, move.cwiseAbs().maxCoeff()));
    const VectorXd before = spectrum.coefficients;
    spectrum.coefficients += move;
    auto rises = spectrum.coefficients.tail(kRises);
    rises = rises.cwiseMax(0.0).cwiseMin(1.0).eval();
    if ((spectrum.coefficients - before).cwiseAbs().maxCoeff() < 1e-4) break;
  }
  return spectrum;
}

}  // namespace sinew::diagnosis

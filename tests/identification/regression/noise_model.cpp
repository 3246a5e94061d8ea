// SPDX-License-Identifier: GPL-3.0-or-later
// The noise model on noise whose spectrum is known.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/regression/noise_model.h"
#include "identification/regression/spectrum.h"

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kSamples = 6000, kBins = 2400;

/// First-order autoregressive noise and, per bin, its true variance.
VectorXd autoregressive(double pole, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss;
  VectorXd x(kSamples);
  double state = 0.0;
  for (Index i = -500; i < kSamples; ++i) {
    state = pole * state + gauss(random);
    if (i >= 0) x(i) = state;
  }
  return x;
}

double true_variance(double pole, Index bin) {
  const double w = 2.0 * M_PI * static_cast<double>(bin) / static_cast<double>(kSamples);
  return 1.0 / (1.0 - 2.0 * pole * std::cos(w) + pole * pole);
}

/// Mean of ln(estimate / truth) over a range of bins.
double bias(const VectorXd& estimate, double pole, Index from, Index to) {
  double sum = 0.0;
  for (Index b = from; b < to; ++b) sum += std::log(estimate(b) / true_variance(pole, b));
  return sum / static_cast<double>(to - from);
}

}  // namespace

TEST_CASE("the band keeps energy and comes back") {
  const VectorXd x = autoregressive(0.9, 3);
  const MatrixXd band = to_band(x, kSamples / 2);
  CHECK(band.squaredNorm() == Approx(x.squaredNorm()).epsilon(1e-3));
  const VectorXd low = from_band(to_band(x, 200), kSamples);
  CHECK((to_band(low, 200) - to_band(x, 200)).norm() < 1e-9 * x.norm());
}

TEST_CASE("the noise spectrum is found, and a fit's appetite is put back") {
  const double pole = 0.95;
  const VectorXd residual = to_band(autoregressive(pole, 11), kBins);
  const VectorXd none = VectorXd::Zero(kBins);
  CHECK(std::abs(bias(noise_spectrum(residual, none, 1.0), pole, 5, kBins)) < 0.05);

  // Sixty sines below bin 60 eat half of the noise there.
  MatrixXd basis = MatrixXd::Zero(2 * kBins, 60);
  for (Index c = 0; c < 60; ++c) basis(2 * c + 2, c) = 1.0;
  const VectorXd left = residual - basis * (basis.transpose() * residual);
  VectorXd leverage = VectorXd::Zero(kBins);
  for (Index c = 0; c < basis.cols(); ++c) leverage += bin_energy(basis.col(c));
  CHECK(std::abs(bias(noise_spectrum(left, leverage, 1.0), pole, 5, 50)) < 0.35);
  // Without the correction the noise would be taken for half of what it is.
  CHECK(bias(noise_spectrum(left, none, 1.0), pole, 5, 50) < -0.45);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/surrogates.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// ln of the upper incomplete gamma ratio; the asymptotic series where the ratio underflows.
double log_upper_gamma(double shape, double x) {
  if (x <= 0.0) return 0.0;
  if (x < shape + 300.0) {
    // Doubles are enough here; Boost's usual policy computes in long double, at several times the
    // price.
    using namespace boost::math::policies;
    const double q = boost::math::gamma_q(shape, x, policy<promote_double<false>>());
    if (q > 1e-290) return std::log(q);
  }
  return (shape - 1.0) * std::log(x) - x - std::lgamma(shape) + std::log1p((shape - 1.0) / x);
}

VectorXd one_surrogate(const NoiseModel& noise, const VectorXd& window, std::mt19937_64& random) {
  const Index bins = noise.leftover.size();
  VectorXd band(2 * bins);
  for (Index b = 0; b < bins; ++b) {
    const double turns = std::ldexp(static_cast<double>(random() >> 11), -53);
    const double phase = 2.0 * std::numbers::pi * turns;
    const double amplitude = std::sqrt(noise.leftover(b));
    band(2 * b) = amplitude * std::cos(phase);
    band(2 * b + 1) = b == 0 ? 0.0 : amplitude * std::sin(phase);
  }
  const VectorXd even = from_band(band, window.size());
  return to_band(even.cwiseProduct(noise.level).cwiseProduct(window), bins);
}

}  // namespace

std::vector<Eigen::MatrixXf> make_surrogates(const Design& design,
                                             const std::vector<NoiseModel>& noise, int count,
                                             unsigned seed) {
  std::vector<Eigen::MatrixXf> surrogates(noise.size());
  for (std::size_t s = 0; s < noise.size(); ++s)
    if (noise[s].leftover.size() > 0) surrogates[s].resize(2 * noise[s].leftover.size(), count);
  tbb::parallel_for(0, count, [&](int i) {
    std::mt19937_64 random(seed * 1000003ULL + static_cast<unsigned>(i));
    for (std::size_t s = 0; s < noise.size(); ++s)
      if (surrogates[s].size() > 0)
        surrogates[s].col(i) =
            one_surrogate(noise[s], design.window(static_cast<int>(s)), random).cast<float>();
  });
  return surrogates;
}

NullDistribution::NullDistribution(const VectorXd& samples) {
  const double n = static_cast<double>(samples.size());
  const double positive = static_cast<double>((samples.array() > 0.0).count());
  positive_ = std::max(positive, 1.0) / n;
  mean_ = samples.mean();
  if (positive < 5.0) return;
  const double mean = samples.sum() / positive;
  const double variance = samples.squaredNorm() / positive - mean * mean;
  shape_ = std::clamp(mean * mean / std::max(variance, 1e-12), 0.2, 200.0);
  scale_ = mean / shape_;
}

double NullDistribution::surprise(double value) const {
  if (value <= 0.0) return 0.0;
  return -std::log(positive_) - log_upper_gamma(shape_, value / scale_);
}

FamilyNull::FamilyNull(const VectorXd& largest) : sorted_(largest) {
  std::sort(sorted_.begin(), sorted_.end());
  // The maximum of m independent exponential surprises is Gumbel with location ln m.
  const double euler = 0.57721566490153286;
  if (sorted_.size() > 0) tests_ = std::max(1.0, std::exp(sorted_.mean() - euler));
}

double FamilyNull::p_value(double surprise) const {
  const double tail = -std::expm1(tests_ * std::log1p(-std::min(std::exp(-surprise), 1.0 - 1e-16)));
  if (sorted_.size() == 0) return tail;
  const auto above = sorted_.end() - std::lower_bound(sorted_.begin(), sorted_.end(), surprise);
  const double n = static_cast<double>(sorted_.size());
  // Inside the surrogates' range their count speaks, beyond it the fitted tail.
  return above >= 5 ? static_cast<double>(above) / n : std::min(1.0, std::max(tail, 0.0));
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/trials/compared.h"

#include <algorithm>
#include <cmath>

namespace sinew::trials {
namespace {

/// Modified Bessel function of order zero.
double bessel(double x) {
  double sum = 1.0, term = 1.0;
  for (int k = 1; k < 40; ++k) {
    term *= 0.25 * x * x / (static_cast<double>(k) * k);
    sum += term;
  }
  return sum;
}

VectorXd windowed_sinc(double cutoff, double step, Index half, double beta) {
  VectorXd kernel(2 * half + 1);
  for (Index i = -half; i <= half; ++i) {
    const double x = static_cast<double>(i), u = x / static_cast<double>(half + 1);
    const double angle = 2.0 * pi * cutoff * step * x;
    const double sinc = i == 0 ? 1.0 : std::sin(angle) / angle;
    kernel(i + half) = sinc * bessel(beta * std::sqrt(std::max(0.0, 1.0 - u * u)));
  }
  return kernel / kernel.sum();
}

/// The ends are continued by point reflection.
VectorXd convolved(const VectorXd& x, const VectorXd& kernel) {
  const Index half = kernel.size() / 2, n = x.size();
  VectorXd longer(n + 2 * half);
  for (Index i = 0; i < half; ++i) {
    longer(half - 1 - i) = 2.0 * x(0) - x(std::min(i + 1, n - 1));
    longer(half + n + i) = 2.0 * x(n - 1) - x(std::max<Index>(n - 2 - i, 0));
  }
  longer.segment(half, n) = x;
  VectorXd y(n);
  for (Index k = 0; k < n; ++k) y(k) = kernel.dot(longer.segment(k, kernel.size()));
  return y;
}

VectorXd slope_of(const VectorXd& x, double step) {
  const Index n = x.size();
  VectorXd d = VectorXd::Zero(n);
  for (Index k = 1; k + 1 < n; ++k) d(k) = (x(k + 1) - x(k - 1)) / (2.0 * step);
  d(0) = d(1);
  d(n - 1) = d(n - 2);
  return d;
}

VectorXd picked(const VectorXd& x, const VectorXd& mask) {
  VectorXd y(static_cast<Index>(mask.sum() + 0.5));
  Index at = 0;
  for (Index k = 0; k < x.size(); ++k)
    if (mask(k) > 0.5) y(at++) = x(k);
  return y;
}

}  // namespace

double rms(const VectorXd& x) {
  return x.size() == 0 ? 0.0 : std::sqrt(x.squaredNorm() / static_cast<double>(x.size()));
}

double documented_band(double step) {
  return std::min(60.0, 0.1 / step);
}

ComparedFilter::ComparedFilter(double step, double band) : band_(band) {
  constexpr double attenuation = 60.0, beta = 5.653;
  const double transition = 2.0 * pi * 0.5 * band * step;
  half_ = static_cast<Index>(std::ceil(0.5 * (attenuation - 8.0) / (2.285 * transition)));
  every_ = std::max<Index>(1, static_cast<Index>(std::floor(1.0 / (2.5 * band * step) + 1e-9)));
  kernel_ = windowed_sinc(1.25 * band, step, half_, beta);
}

VectorXd ComparedFilter::operator()(const VectorXd& x) const {
  const Index kept = x.size() > 2 * half_ ? (x.size() - 2 * half_ - 1) / every_ + 1 : 0;
  VectorXd y(kept);
  for (Index k = 0; k < kept; ++k) y(k) = kernel_.dot(x.segment(k * every_, kernel_.size()));
  return y;
}

VectorXd ComparedFilter::mask(const VectorXd& moving) const {
  const Index kept = moving.size() > 2 * half_ ? (moving.size() - 2 * half_ - 1) / every_ + 1 : 0;
  VectorXd y(kept);
  for (Index k = 0; k < kept; ++k) y(k) = moving(k * every_ + half_) > 0.5 ? 1.0 : 0.0;
  return y;
}

Size size_of(const std::vector<Channel>& channels, double step) {
  Size size;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Channel& channel = channels[c];
    const ComparedFilter filter(step, channel.band);
    VectorXd mask = filter.mask(channel.moving);
    // Where next to nothing would be left, rests count as well.
    if (mask.sum() < 0.3 * static_cast<double>(mask.size())) mask.setOnes();
    const VectorXd noise = picked(filter(channel.noise), mask);
    VectorXd left = picked(filter(channel.added), mask);
    const double unit = rms(noise);
    if (!(unit > 0.0)) continue;
    const double plain = rms(left) / unit;
    if (channel.fitted.cols() > 0) {
      MatrixXd columns(left.size(), channel.fitted.cols());
      for (Index i = 0; i < columns.cols(); ++i) {
        columns.col(i) = picked(filter(channel.fitted.col(i)), mask);
        const double norm = columns.col(i).norm();
        if (norm > 0.0) columns.col(i) /= norm;
      }
      left -= columns * columns.completeOrthogonalDecomposition().solve(left);
    }
    const double excess = rms(left) / unit;
    size.plain = std::max(size.plain, plain);
    if (excess < size.excess || (size.channel >= 0 && excess == size.excess)) continue;
    size.excess = excess;
    size.channel = static_cast<int>(c);
  }
  return size;
}

Smoothed smoothed(const VectorXd& q, double step, double cutoff) {
  const Index half = static_cast<Index>(std::ceil(1.2 / (cutoff * step)));
  const VectorXd kernel = windowed_sinc(1.25 * cutoff, step, half, 7.0);
  Smoothed s;
  s.q = convolved(q, kernel);
  s.v = slope_of(s.q, step);
  s.a = slope_of(s.v, step);
  return s;
}

}  // namespace sinew::trials

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/compared.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>

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

enum class Window { kaiser, blackman };

/// x in samples from the middle, cutoff in cycles a sample.
double sinc_at(double x, double cutoff, Index half, Window window) {
  const double u = x / static_cast<double>(half + 1), angle = 2.0 * pi * cutoff * x;
  if (std::abs(u) >= 1.0) return 0.0;
  const double shape = window == Window::kaiser
                           ? bessel(5.65 * std::sqrt(1.0 - u * u))
                           : 0.42 + 0.5 * std::cos(pi * u) + 0.08 * std::cos(2.0 * pi * u);
  return shape * (std::abs(angle) < 1e-9 ? 1.0 : std::sin(angle) / angle);
}

VectorXd windowed_sinc(double cutoff, Index half, Window window) {
  VectorXd kernel(2 * half + 1);
  for (Index i = -half; i <= half; ++i)
    kernel(i + half) = sinc_at(static_cast<double>(i), cutoff, half, window);
  return kernel / kernel.sum();
}

/// Its first derivative, exact on straight lines, or its second, exact on parabolas.
VectorXd differentiating(double cutoff, Index half, int derivative) {
  constexpr double h = 1e-3;
  const VectorXd at =
      VectorXd::LinSpaced(2 * half + 1, -static_cast<double>(half), static_cast<double>(half));
  VectorXd w(at.size());
  double sum = 0.0;
  for (Index i = 0; i < at.size(); ++i) {
    const double middle = sinc_at(at(i), cutoff, half, Window::blackman),
                 low = sinc_at(at(i) - h, cutoff, half, Window::blackman),
                 high = sinc_at(at(i) + h, cutoff, half, Window::blackman);
    w(i) = derivative == 1 ? (low - high) / (2.0 * h) : (low - 2.0 * middle + high) / (h * h);
    sum += middle;
  }
  if (derivative == 1) {
    w.array() -= w.mean();
    return w / w.dot(at);
  }
  w /= sum;
  w.array() -= w.mean();
  const VectorXd square = at.array().square();
  const VectorXd parabola = square.array() - square.mean();
  return w + (1.0 - 0.5 * w.dot(square)) / (0.5 * parabola.dot(square)) * parabola;
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

}  // namespace

double rms(const VectorXd& x) {
  return x.size() == 0 ? 0.0 : std::sqrt(x.squaredNorm() / static_cast<double>(x.size()));
}

double documented_band(double step) {
  return std::min(60.0, 0.1 / step);
}

double rig_band(double step) {
  return std::min(60.0, 0.4 / step);
}

ComparedFilter::ComparedFilter(double step, double band)
    : band_(band),
      step_(step),
      every_(std::max<Index>(1, static_cast<Index>(std::floor(0.4 / (band * step))))) {
  constexpr double edge = 0.25;  // s: the smoothers reach beyond the ends of a log
  edge_ = static_cast<Index>(std::lround(edge / step));
  half_ = 9 * every_;
  kernel_ = windowed_sinc(0.5 / static_cast<double>(every_), half_, Window::kaiser);
}

/// The next lower even number without a prime factor above 5.
Index ComparedFilter::kept(const VectorXd& x) const {
  const Index inner = x.size() - 2 * (edge_ + half_);
  Index n = inner > 0 ? (inner - 1) / every_ + 1 : 0;
  const auto is_quick = [](Index count) {
    for (const Index prime : {2, 3, 5})
      while (count % prime == 0) count /= prime;
    return count == 1;
  };
  while (n > 1 && !(n % 2 == 0 && is_quick(n))) --n;
  return n;
}

VectorXd ComparedFilter::operator()(const VectorXd& x) const {
  VectorXd y(kept(x));
  for (Index k = 0; k < y.size(); ++k)
    y(k) = kernel_.dot(x.segment(edge_ + k * every_, kernel_.size()));
  return y;
}

VectorXd ComparedFilter::at_instants(const VectorXd& x) const {
  VectorXd y(kept(x));
  for (Index k = 0; k < y.size(); ++k) y(k) = x(edge_ + half_ + k * every_);
  return y;
}

VectorXd ComparedFilter::in_band(const VectorXd& kept) const {
  Eigen::FFT<double> fft;
  std::vector<double> in(kept.begin(), kept.end());
  std::vector<std::complex<double>> lines;
  if (in.empty()) return {};
  fft.fwd(lines, in);
  // A line for each whole number of periods; the filter lets part of what is above the band
  // through.
  const double periods = band_ * step_ * static_cast<double>(every_ * kept.size());
  const auto count = std::min(kept.size() / 2, static_cast<Index>(periods) + 1);
  VectorXd band(2 * count);
  for (Index k = 0; k < count; ++k) {
    const std::complex<double> line =
        lines[static_cast<std::size_t>(k)] * (k == 0 ? 1.0 : std::numbers::sqrt2);
    band(2 * k) = line.real();
    band(2 * k + 1) = line.imag();
  }
  return band;
}

VectorXd ComparedFilter::ends(const VectorXd& x) const {
  const Index n = kept(x);
  const double tail = 0.05 * static_cast<double>(n);
  VectorXd weight(n);
  for (Index k = 0; k < n; ++k) {
    const double inside = static_cast<double>(std::min(k, n - 1 - k)) + 0.5;
    weight(k) =
        inside < tail ? std::pow(std::sin(0.5 * std::numbers::pi * inside / tail), 2.0) : 1.0;
  }
  return weight;
}

namespace {

/// Half of the squares of the lines (real and imaginary part of each, one after the other), over
/// the noise's spectrum: its lines nearby, one with another.
double known_evidence(const VectorXd& lines, const VectorXd& noise) {
  constexpr Index nearby = 8;  // each way
  const Index count = lines.size() / 2;
  double nats = 0.0;
  for (Index k = 0; k < count; ++k) {
    const Index first = std::max<Index>(0, k - nearby), last = std::min(count - 1, k + nearby);
    const double two = 2.0 * noise.segment(2 * first, 2 * (last - first + 1)).squaredNorm() /
                       static_cast<double>(2 * (last - first + 1));
    if (two > 0.0) nats += lines.segment(2 * k, 2).squaredNorm() / two;
  }
  return nats;
}

}  // namespace

Size size_of(const std::vector<Channel>& channels, double step) {
  Size size;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Channel& channel = channels[c];
    const ComparedFilter filter(step, channel.band);
    const VectorXd weight =
        filter.at_instants(channel.moving).cwiseProduct(filter.ends(channel.moving));
    const auto seen = [&](const VectorXd& x) {
      return filter.in_band(filter(x).cwiseProduct(weight));
    };
    const VectorXd noise = seen(channel.noise);
    const double unit = noise.norm();
    VectorXd left = seen(channel.added);
    if (!(unit > 0.0)) continue;
    const double plain = left.norm() / unit;
    if (channel.fitted.cols() > 0) {
      MatrixXd columns(left.size(), channel.fitted.cols());
      for (Index i = 0; i < columns.cols(); ++i) {
        columns.col(i) = seen(channel.fitted.col(i));
        const double norm = columns.col(i).norm();
        if (norm > 0.0) columns.col(i) /= norm;
      }
      left -= columns * columns.completeOrthogonalDecomposition().solve(left);
    }
    const double excess = left.norm() / unit;
    size.nats += known_evidence(left, noise);
    size.plain = std::max(size.plain, plain);
    if (excess < size.excess || (size.channel >= 0 && excess == size.excess)) continue;
    size.excess = excess;
    size.channel = static_cast<int>(c);
  }
  return size;
}

Smoothed smoothed(const VectorXd& q, double step, double cutoff) {
  const double share = std::min(0.5, 1.25 * cutoff * step);
  const auto half = std::max<Index>(4, static_cast<Index>(std::ceil(5.0 / share)));
  return {convolved(q, windowed_sinc(share, half, Window::blackman)),
          convolved(q, differentiating(share, half, 1)) / step,
          convolved(q, differentiating(share, half, 2)) / (step * step)};
}

}  // namespace sinew::trials

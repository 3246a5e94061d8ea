// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/filter.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double kPi = std::numbers::pi;
constexpr double kKaiserBeta = 5.65;  // 60 dB

/// Modified Bessel function of order 0 by its series (arguments stay below 6).
double bessel_i0(double x) {
  double term = 1.0, sum = 1.0;
  for (int k = 1; k < 40 && term > 1e-17 * sum; ++k) {
    term *= 0.25 * x * x / (static_cast<double>(k) * static_cast<double>(k));
    sum += term;
  }
  return sum;
}

/// Kaiser's window is the shorter one but ends in a step; differentiated, a step is a pulse, so
/// what is differentiated twice gets Blackman's, which ends without step or kink.
enum class Window { kaiser, blackman };

double window_value(Window window, double u) {
  if (window == Window::kaiser) return bessel_i0(kKaiserBeta * std::sqrt(1.0 - u * u));
  return 0.42 + 0.5 * std::cos(kPi * u) + 0.08 * std::cos(2.0 * kPi * u);
}

/// Windowed sinc of the given cutoff [cycles/sample], x samples from its centre.
double kernel_value(double x, double cutoff, double half_width, Window shape) {
  const double u = x / half_width;
  if (std::abs(u) >= 1.0) return 0.0;
  const double window = window_value(shape, u);
  const double phase = 2.0 * kPi * cutoff * x;
  const double sinc = std::abs(phase) < 1e-9 ? 1.0 : std::sin(phase) / phase;
  return sinc * window;  // the scale follows from what the kernel is to do to polynomials
}

/// A second derivative that parabolas stay exact under, from weights that pass sines well. Scaling
/// them would do, and would get all the faster accelerations wrong by what is missing near zero
/// frequency alone: 0.1 % at ten samples a period of the cutoff, 1 % at five. What is missing is
/// added as the weights of a fitted parabola, which act there.
VectorXd exact_on_parabolas(VectorXd w, const VectorXd& at) {
  VectorXd square = at.array().square();
  const auto curvature = [&square](const VectorXd& x) { return 0.5 * x.dot(square); };
  w.array() -= w.mean();
  const VectorXd parabola = square.array() - square.mean();
  return w + (1.0 - curvature(w)) / curvature(parabola) * parabola;
}

/// Weights w with y(c) = sum_j w_j x(c + j), j = -half..half, for the signal `advance` samples on.
VectorXd kernel(double cutoff, Index half, double advance, int derivative,
                Window shape = Window::kaiser) {
  const double width = static_cast<double>(half) + 1.0;
  const double h = 1e-3;
  VectorXd w(2 * half + 1);
  double sum = 0.0;
  for (Index j = -half; j <= half; ++j) {
    const double x = static_cast<double>(j) - advance;
    const double centre = kernel_value(x, cutoff, width, shape);
    // d/dt of y moves the kernel, hence the minus sign of the first derivative.
    const double low = kernel_value(x - h, cutoff, width, shape),
                 high = kernel_value(x + h, cutoff, width, shape);
    const double value = derivative == 0   ? centre
                         : derivative == 1 ? -(high - low) / (2.0 * h)
                                           : (high - 2.0 * centre + low) / (h * h);
    w(j + half) = value;
    sum += centre;
  }
  if (derivative == 0) return w / sum;
  // Exact on polynomials: a constant gives 0, and x^d gives d! (d = order).
  const VectorXd at =
      VectorXd::LinSpaced(2 * half + 1, -static_cast<double>(half), static_cast<double>(half))
          .array() -
      advance;
  if (derivative == 2) return exact_on_parabolas(w / sum, at);
  w.array() -= w.mean();
  return w / w.dot(at);
}

bool is_smooth(Index n) {
  for (const Index p : {2, 3, 5})
    while (n % p == 0) n /= p;
  return n == 1;
}

}  // namespace

DecimatingFilter design_decimating_filter(double step, double band_hz) {
  if (!(step > 0.0) || !(band_hz > 0.0))
    throw std::invalid_argument("design_decimating_filter: step and band must be positive");
  DecimatingFilter filter;
  filter.step = step;
  filter.factor = std::max(1, static_cast<int>(std::floor(0.4 / (band_hz * step))));
  filter.band_hz = std::min(band_hz, 0.4 / (step * filter.factor));
  filter.half_width = 9 * filter.factor;
  filter.value = kernel(0.5 / filter.factor, filter.half_width, 0.0, 0);
  filter.rate = kernel(0.5 / filter.factor, filter.half_width, 0.0, 1) / step;
  return filter;
}

Index filtered_length(const DecimatingFilter& filter, Index samples) {
  const Index inner = samples - 2 * filter.half_width;
  Index n = inner <= 0 ? 0 : (inner - 1) / filter.factor + 1;
  while (n > 1 && !(n % 2 == 0 && is_smooth(n))) --n;
  return n < 32 ? 0 : n;
}

Index centre_sample(const DecimatingFilter& filter, Index k) {
  return filter.half_width + k * filter.factor;
}

MatrixXd filter_decimate(const DecimatingFilter& filter, const MatrixXd& x, double advance,
                         int derivative) {
  const Index n = filtered_length(filter, x.rows());
  const VectorXd w = advance == 0.0 ? (derivative == 0 ? filter.value : filter.rate)
                                    : VectorXd(kernel(0.5 / filter.factor, filter.half_width,
                                                      advance / filter.step, derivative) /
                                               std::pow(filter.step, derivative));
  MatrixXd out(n, x.cols());
  for (Index c = 0; c < x.cols(); ++c)
    for (Index k = 0; k < n; ++k) out(k, c) = w.dot(x.col(c).segment(k * filter.factor, w.size()));
  return out;
}

namespace {

/// A sample before the first or after the last one is as far to the other side of that one as its
/// mirror image, as often as it takes.
double mirrored(const Eigen::Ref<const VectorXd>& p, Index at) {
  const Index last = p.size() - 1;
  double offset = 0.0, sign = 1.0;
  while (at < 0 || at > last) {
    const Index end = at < 0 ? 0 : last;
    offset += 2.0 * sign * p(end);
    sign = -sign;
    at = 2 * end - at;
  }
  return offset + sign * p(at);
}

}  // namespace

Motion differentiate(const MatrixXd& position, double step, double cutoff_hz) {
  const double cutoff = std::min(0.5, 1.25 * cutoff_hz * step);
  // Transition from about 0.75 to 1.3 cutoff at 60 dB.
  const Index half = std::max<Index>(4, static_cast<Index>(std::ceil(2.5 / cutoff / 0.5)));
  const Index n = position.rows();
  if (n < 2) throw std::invalid_argument("differentiate: a log of one row has no rate");
  const VectorXd w0 = kernel(cutoff, half, 0.0, 0, Window::blackman),
                 w1 = kernel(cutoff, half, 0.0, 1, Window::blackman) / step,
                 w2 = kernel(cutoff, half, 0.0, 2, Window::blackman) / (step * step);
  Motion motion{MatrixXd(n, position.cols()), MatrixXd(n, position.cols()),
                MatrixXd(n, position.cols())};
  tbb::parallel_for(0, static_cast<int>(position.cols()), [&](int c) {
    const auto p = position.col(c);
    VectorXd padded(n + 2 * half);
    for (Index j = 0; j < padded.size(); ++j) padded(j) = mirrored(p, j - half);
    for (Index k = 0; k < n; ++k) {
      const auto piece = padded.segment(k, w0.size());
      motion.q(k, c) = w0.dot(piece);
      motion.qd(k, c) = w1.dot(piece);
      motion.qdd(k, c) = w2.dot(piece);
    }
  });
  return motion;
}

}  // namespace sinew::diagnosis

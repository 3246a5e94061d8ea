// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Eigen::FFT<double>& transform() {
  thread_local Eigen::FFT<double> fft = [] {
    Eigen::FFT<double> f;
    f.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    return f;
  }();
  return fft;
}

double bin_scale(Index bin, Index samples) {
  return std::sqrt((bin == 0 || 2 * bin == samples ? 1.0 : 2.0) / static_cast<double>(samples));
}

}  // namespace

MatrixXd to_band(const MatrixXd& x, Index bins) {
  const Index n = x.rows();
  if (n % 2 != 0 || bins > n / 2) throw std::invalid_argument("to_band: length must be even");
  MatrixXd band(2 * bins, x.cols());
  std::vector<double> in(static_cast<std::size_t>(n));
  std::vector<std::complex<double>> out;
  for (Index c = 0; c < x.cols(); ++c) {
    VectorXd::Map(in.data(), n) = x.col(c);
    transform().fwd(out, in);
    for (Index b = 0; b < bins; ++b) {
      const std::complex<double> value = out[static_cast<std::size_t>(b)] * bin_scale(b, n);
      band(2 * b, c) = value.real();
      band(2 * b + 1, c) = value.imag();
    }
  }
  return band;
}

MatrixXd from_band(const MatrixXd& band, Index samples) {
  const Index bins = band.rows() / 2;
  MatrixXd x(samples, band.cols());
  std::vector<std::complex<double>> in(static_cast<std::size_t>(samples / 2 + 1));
  std::vector<double> out(static_cast<std::size_t>(samples));
  for (Index c = 0; c < band.cols(); ++c) {
    std::fill(in.begin(), in.end(), 0.0);
    for (Index b = 0; b < bins; ++b)
      in[static_cast<std::size_t>(b)] =
          std::complex<double>(band(2 * b, c), band(2 * b + 1, c)) / bin_scale(b, samples);
    transform().inv(out, in);
    x.col(c) = VectorXd::Map(out.data(), samples);
  }
  return x;
}

VectorXd end_taper(Index samples) {
  constexpr double share = 0.05;
  VectorXd taper = VectorXd::Ones(samples);
  const double length = share * static_cast<double>(samples);
  for (Index k = 0; static_cast<double>(k) + 0.5 < length && 2 * k < samples; ++k) {
    const double away = (static_cast<double>(k) + 0.5) / length;
    taper(k) = taper(samples - 1 - k) = 0.5 - 0.5 * std::cos(std::numbers::pi * away);
  }
  return taper;
}

VectorXd per_row(const VectorXd& per_bin) {
  VectorXd rows(2 * per_bin.size());
  for (Index b = 0; b < per_bin.size(); ++b) rows.segment(2 * b, 2).setConstant(per_bin(b));
  return rows;
}

VectorXd bin_energy(const VectorXd& band) {
  return Eigen::Map<const Eigen::Matrix2Xd>(band.data(), 2, band.size() / 2)
      .colwise()
      .squaredNorm();
}

VectorXd smooth_ratio(const VectorXd& numerator, const VectorXd& denominator, Index least,
                      double share) {
  const Index n = numerator.size();
  VectorXd top = VectorXd::Zero(n + 1), bottom = VectorXd::Zero(n + 1);
  for (Index i = 0; i < n; ++i) {
    top(i + 1) = top(i) + numerator(i);
    bottom(i + 1) = bottom(i) + denominator(i);
  }
  VectorXd smooth(n);
  for (Index i = 0; i < n; ++i) {
    const Index half = std::max(least, static_cast<Index>(share * static_cast<double>(i)));
    // A window cut off at an end keeps its length, so that no estimate rests on few bins.
    const Index low = std::clamp<Index>(i - half, 0, std::max<Index>(0, n - 2 * half - 1));
    const Index high = std::min(n, low + 2 * half + 1);
    smooth(i) = (top(high) - top(low)) / std::max(bottom(high) - bottom(low), 1e-300);
  }
  return smooth;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/expected_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kLeastSamples = 256;
constexpr double kContinued = 0.5;  // s at each end

VectorXd without_line(const VectorXd& x) {
  const Index n = x.size();
  return x - VectorXd::LinSpaced(n, x(0), x(n - 1));
}

/// Hann: what leaks from slow motion falls with the sixth power of the frequency.
VectorXd windowed(const VectorXd& x) {
  const VectorXd phase = VectorXd::LinSpaced(x.size(), 0.0, 2.0 * std::numbers::pi);
  return x.array() * (0.5 - 0.5 * phase.array().cos());
}

/// Point reflection at both ends, of an even length in all.
VectorXd continued(const VectorXd& x, Index more) {
  const Index n = x.size();
  VectorXd y(n + 2 * more);
  y.segment(more, n) = x;
  y.head(more) = (2.0 * x(0) - x.segment(1, more).array()).reverse();
  y.tail(more) = (2.0 * x(n - 1) - x.segment(n - 1 - more, more).array()).reverse();
  return y;
}

/// The same falling less steeply, and nowhere lower: the largest share within `half` bins, averaged
/// over as many. A filter that falls at once rings from one end of a log to the other.
VectorXd without_edges(const VectorXd& share, Index half) {
  if (half < 1) return share;
  const Index n = share.size();
  VectorXd widest(n), result(n);
  for (Index b = 0; b < n; ++b) {
    const Index low = std::max<Index>(0, b - half), high = std::min(n - 1, b + half);
    widest(b) = share.segment(low, high - low + 1).maxCoeff();
  }
  const VectorXd weight =
      (VectorXd::LinSpaced(2 * half + 1, -1.0, 1.0).array() * std::numbers::pi).cos() + 1.0;
  for (Index b = 0; b < n; ++b) {
    const Index low = std::max<Index>(0, b - half), high = std::min(n - 1, b + half);
    const auto own = weight.segment(low - b + half, high - low + 1);
    result(b) = widest.segment(low, high - low + 1).dot(own) / own.sum();
  }
  return result;
}

}  // namespace

VectorXd share_of_motion(const VectorXd& reading, double step, double quiet_from, Index bins) {
  const Index n = reading.size() - reading.size() % 2, own = n / 2;
  const auto quiet = static_cast<Index>(std::ceil(quiet_from * step * static_cast<double>(n)));
  if (n < kLeastSamples || quiet >= own - 8) return VectorXd::Ones(bins);
  const VectorXd x = windowed(without_line(reading.head(n)));
  const VectorXd energy = bin_energy(to_band(x, own));
  const double noise = energy.tail(own - quiet).mean();
  const VectorXd around = smooth_ratio(energy, VectorXd::Ones(own), 6, 0.08);
  VectorXd share = VectorXd::Ones(own);
  for (Index b = 0; b < own; ++b)
    share(b) = around(b) > 0.0 ? std::clamp(1.0 - noise / around(b), 0.0, 1.0) : 1.0;
  // A filter that falls once and stays low is a short one.
  Index last = own - 1;
  while (last > 0 && (last >= quiet || share(last) < 0.5)) --last;
  for (Index b = last; b-- > 0;) share(b) = std::max(share(b), share(b + 1));
  for (Index b = last + 1; b < own; ++b) share(b) = std::min(share(b), share(b - 1));
  VectorXd result(bins);
  for (Index b = 0; b < bins; ++b) result(b) = share(std::min(own - 1, b * own / bins));
  // As wide as makes the filter no longer than the reading is continued.
  const double per_hz = 2.0 * step * static_cast<double>(bins);
  return without_edges(result, static_cast<Index>(std::lround(per_hz / kContinued)));
}

MatrixXd expected_position(const MatrixXd& reading, double step, double quiet_from) {
  const Index n = reading.rows();
  if (n < kLeastSamples) return reading;
  const Index more = std::min(n - 1, static_cast<Index>(std::lround(kContinued / step)));
  MatrixXd expected(n, reading.cols());
  for (Index c = 0; c < reading.cols(); ++c) {
    const VectorXd whole = continued(reading.col(c), more);
    const Index even = whole.size() - whole.size() % 2;
    const VectorXd flat = without_line(whole.head(even));
    const Index bins = even / 2;
    const VectorXd share = share_of_motion(reading.col(c), step, quiet_from, bins);
    const VectorXd noise =
        from_band(per_row(VectorXd::Ones(bins) - share).asDiagonal() * to_band(flat, bins), even);
    // A last sample that made the length odd stays as it was read.
    VectorXd off = VectorXd::Zero(n);
    const Index known = std::min(n, even - more);
    off.head(known) = noise.segment(more, known);
    expected.col(c) = reading.col(c) - off;
  }
  return expected;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/order_spectrum.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <utility>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kFalseAlarm = 1e-4;  // of a search over all orders
// What a line may lack at its whole order of the energy at its top: an eighth of its width, and
// noise.
constexpr double kOffTop = 0.05, kByNoise = 3.0;
constexpr int kBinsAPeriod = 8;  // of the highest order
constexpr double kMostBins = 4e6;

/// Energy at equally spaced orders, from 0 on.
struct OrderSpectrum {
  double travel = 0.0;  ///< turns
  double step = 0.0;    ///< orders; an eighth of what the travel resolves
  VectorXd energy;
  /// The next one to an order.
  Index index(double order) const {
    return std::clamp<Index>(static_cast<Index>(std::lround(order / step)), 0, energy.size() - 1);
  }
};

/// The effort's integral over the angle in each of equal parts of the travel: time at rest counts
/// for nothing, and a part that is passed often for as much more.
OrderSpectrum spectrum_of(const ShaftLog& log, int highest) {
  const double low = log.turns.minCoeff(), travel = log.turns.maxCoeff() - low;
  const double bins_a_turn = static_cast<double>(kBinsAPeriod * highest);
  const double wanted = std::ceil(travel * bins_a_turn) + 1.0;
  if (!(travel >= kLeastTurns) || !(wanted <= kMostBins)) return {};
  std::size_t size = 1;
  while (static_cast<double>(size) < 8.0 * wanted) size *= 2;
  std::vector<double> bins(size, 0.0);
  for (Index i = 1; i < log.turns.size(); ++i) {
    const auto at = static_cast<std::size_t>((log.turns(i) - low) * bins_a_turn);
    bins[at] += log.value(i) * std::abs(log.turns(i) - log.turns(i - 1));
  }
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> lines;
  fft.fwd(lines, bins);
  OrderSpectrum spectrum;
  spectrum.travel = travel;
  spectrum.step = bins_a_turn / static_cast<double>(size);
  const auto count = static_cast<Index>((highest + 8.0) / spectrum.step);
  spectrum.energy.resize(std::min(count, static_cast<Index>(size / 2)));
  for (Index k = 0; k < spectrum.energy.size(); ++k)
    spectrum.energy(k) = std::norm(lines[static_cast<std::size_t>(k)]);
  return spectrum;
}

/// Mean energy of noise around an order, by the median of what is around its line.
double noise_around(const OrderSpectrum& s, int order) {
  const double line = 1.5 / s.travel, around = 2.0 + 8.0 / s.travel;
  std::vector<double> noise;
  for (Index k = s.index(order - around); k <= s.index(order + around); ++k)
    if (std::abs(s.step * static_cast<double>(k) - order) > line) noise.push_back(s.energy(k));
  if (noise.empty()) return 0.0;
  const auto middle = noise.begin() + static_cast<std::ptrdiff_t>(noise.size() / 2);
  std::nth_element(noise.begin(), middle, noise.end());
  return *middle / std::log(2.0);
}

/// The logs' energies at a whole order, each over its noise; 0 where their sum has its top
/// elsewhere: a line between whole orders is no tooth's, pole's or slot's.
double prominence(const std::vector<OrderSpectrum>& spectra, int order) {
  constexpr int steps = 20;  // to half an order on each side
  VectorXd sum = VectorXd::Zero(2 * steps + 1);
  for (const OrderSpectrum& s : spectra) {
    const double noise = noise_around(s, order);
    if (!(noise > 0.0)) continue;
    for (Index i = 0; i < sum.size(); ++i)
      sum(i) += s.energy(s.index(order + 0.5 * static_cast<double>(i - steps) / steps)) / noise;
  }
  return sum(steps) >= (1.0 - kOffTop) * sum.maxCoeff() - kByNoise ? sum(steps) : 0.0;
}

/// Sine and cosine of a line beside its log, each sample by its weight, in equal blocks of time.
class LineSums {
 public:
  LineSums(const ShaftLog& log, int order, int blocks, const Eigen::ArrayXd& weight)
      : blocks_(blocks), columns_(weight.size(), 2) {
    const Index n = weight.size();
    const Eigen::ArrayXd angle = 2.0 * std::numbers::pi * order * log.turns.tail(n).array();
    columns_ << weight * angle.sin(), weight * angle.cos();
    values_ = weight * log.value.tail(n).array();
    gram_ = 1e-12 * static_cast<double>(n) * Eigen::Matrix2d::Identity() +
            columns_.transpose() * columns_;
    target_ = columns_.transpose() * values_;
  }
  Eigen::Vector2d fit() const { return gram_.ldlt().solve(target_); }
  Eigen::Vector2d fit_without(int block) const {
    const auto own = columns_of(block);
    const Eigen::Matrix2d gram = gram_ - own.transpose() * own;
    return gram.ldlt().solve(target_ - own.transpose() * values_of(block));
  }
  Eigen::Ref<const VectorXd> values_of(int block) const {
    return values_.segment(first(block), first(block + 1) - first(block));
  }
  Eigen::Ref<const Eigen::MatrixXd> columns_of(int block) const {
    return columns_.middleRows(first(block), first(block + 1) - first(block));
  }

 private:
  Index first(int block) const { return values_.size() * block / blocks_; }

  int blocks_;
  Eigen::MatrixXd columns_;
  VectorXd values_;
  Eigen::Matrix2d gram_;
  Eigen::Vector2d target_;
};

}  // namespace

std::vector<OrderLine> order_lines(const std::vector<ShaftLog>& logs, int lowest, int highest) {
  std::vector<OrderSpectrum> spectra;
  for (const ShaftLog& log : logs) {
    OrderSpectrum s = spectrum_of(log, highest);
    if (s.energy.size() > 0) spectra.push_back(std::move(s));
  }
  std::vector<OrderLine> found;
  if (spectra.empty() || highest < lowest) return found;
  const double orders = highest - lowest + 1;
  for (int order = lowest; order <= highest; ++order) {
    OrderLine line{order, prominence(spectra, order), 1.0};
    if (!(line.prominence > 0.0)) continue;
    // Energies of noise are exponentially distributed.
    line.chance =
        orders * boost::math::gamma_q(static_cast<double>(spectra.size()), line.prominence);
    if (line.chance < kFalseAlarm) found.push_back(line);
  }
  std::stable_sort(found.begin(), found.end(), [](const OrderLine& a, const OrderLine& b) {
    return a.prominence > b.prominence;
  });
  return found;
}

LineFit fit_line(const ShaftLog& log, int order, int blocks) {
  const Index n = log.turns.size() - 1;
  const Eigen::ArrayXd made = (log.turns.tail(n) - log.turns.head(n)).array().abs();
  const LineSums all(log, order, blocks, made.sqrt());
  const LineSums slow(log, order, blocks, (order * made < log.fastest).select(made.sqrt(), 0.0));
  const Eigen::Vector2d size = slow.fit();
  LineFit fit{size(0), size(1), 0.0, 0.0, VectorXd(blocks), VectorXd(blocks)};
  Eigen::Matrix2Xd left_out(2, blocks);
  for (int b = 0; b < blocks; ++b) {
    left_out.col(b) = slow.fit_without(b);
    const auto value = all.values_of(b);
    fit.without(b) = value.squaredNorm();
    fit.with(b) = (value - all.columns_of(b) * all.fit_without(b)).squaredNorm();
  }
  const Eigen::Vector2d error = std::sqrt((blocks - 1.0) / blocks) *
                                (left_out.colwise() - left_out.rowwise().mean()).rowwise().norm();
  fit.sine_error = error(0);
  fit.cosine_error = error(1);
  return fit;
}

}  // namespace sinew::diagnosis

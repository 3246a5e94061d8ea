// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/order_spectrum.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "identification/regression/noise_model.h"
#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFalseAlarm = 1e-4;  // of a search over all orders
// What a line may lack at its whole order of the energy at its top: an eighth of its width, and
// noise.
constexpr double kOffTop = 0.05, kByNoise = 3.0;

/// 1 / the variance of noise with the smooth spectrum of what to_band() gives, each bin. `weight`:
/// of the samples.
VectorXd precision_of(const VectorXd& band, const VectorXd& weight) {
  const VectorXd nothing_fitted = VectorXd::Zero(band.size() / 2);
  return noise_spectrum(band, nothing_fitted, weight.cwiseAbs2().mean()).cwiseInverse();
}

/// Of each sample, turns from the nearer end of its motion one way, rests being no motion.
VectorXd turns_from_reversal(const ShaftLog& log, Index n) {
  VectorXd turns = VectorXd::Zero(n);
  for (Index from = 0, to = 0; from < n; from = to) {
    for (to = from + 1; to < n && (log.counts(to) > 0.0) == (log.counts(from) > 0.0);) ++to;
    if (!(log.counts(from) > 0.0)) continue;
    const Eigen::ArrayXd own = log.turns.segment(from, to - from).array();
    turns.segment(from, to - from) =
        (own - own(0)).abs().min((own - own(own.size() - 1)).abs()).matrix();
  }
  return turns;
}

/// Which samples tell a ripple from what friction does behind a reversal: those that are half a
/// period of it from one.
Eigen::ArrayXd tells_order(const VectorXd& from_reversal, double order) {
  return (from_reversal.array() * order >= 0.5).cast<double>();
}

/// What a log holds of a sine over the shaft's angle, by the matched filter in noise of the
/// spectrum that the log has: a ripple is a sweep over time, and counts where the noise is low.
class MatchedLines {
 public:
  explicit MatchedLines(const ShaftLog& log) {
    const Index n = log.turns.size() / 2 * 2;
    if (n < 4 || !(travel(log) >= kLeastTurns)) return;
    turns_ = log.turns.head(n);
    made_ = VectorXd::Zero(n);
    made_.tail(n - 1) = (turns_.tail(n - 1) - turns_.head(n - 1)).cwiseAbs();
    weight_ = log.counts.head(n).cwiseProduct(end_taper(n));
    from_reversal_ = turns_from_reversal(log, n);
    if (weight_.isZero(0.0)) return;
    MatrixXd band = to_band(weight_.cwiseProduct(log.value.head(n)), n / 2);
    precision_ = precision_of(band, weight_);
    band.array() *= per_row(precision_).array();
    whitened_ = from_band(band, n);
  }

  /// Energy over its mean in such noise, which is exponentially distributed.
  double energy(double order) const {
    const Eigen::ArrayXd angle = 2.0 * std::numbers::pi * order * turns_.array();
    const Eigen::ArrayXd weight = weight_.array() * tells_order(from_reversal_, order);
    const Eigen::ArrayXd value = weight * whitened_.array();
    const double cosine = (value * angle.cos()).sum(), sine = (value * angle.sin()).sum();
    double mean = 0.0;
    for (Index i = 0; i < turns_.size(); ++i)
      mean += weight(i) * weight(i) * precision_(bin_of(order * made_(i)));
    return mean > 0.0 ? (cosine * cosine + sine * sine) / mean : 0.0;
  }
  bool tells() const { return whitened_.size() > 0; }

 private:
  static double travel(const ShaftLog& log) {
    return log.turns.size() == 0 ? 0.0 : log.turns.maxCoeff() - log.turns.minCoeff();
  }
  /// Where a sine of so many periods a sample has its energy.
  Index bin_of(double periods) const {
    const double folded = std::abs(periods - std::round(periods));
    return std::min(static_cast<Index>(2.0 * folded * static_cast<double>(precision_.size())),
                    precision_.size() - 1);
  }

  VectorXd turns_, made_, from_reversal_, weight_, precision_, whitened_;
};

/// Each log's energies at the orders from `lowest` on, over what noise has by their median: what is
/// left of friction's turning is no stationary noise.
VectorXd energies(const std::vector<MatchedLines>& logs, int lowest, int highest,
                  std::vector<double>& levels) {
  VectorXd sum = VectorXd::Zero(highest - lowest + 1);
  for (const MatchedLines& log : logs) {
    VectorXd own(sum.size());
    for (Index i = 0; i < own.size(); ++i) own(i) = log.energy(static_cast<double>(lowest + i));
    std::vector<double> sorted(own.begin(), own.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    levels.push_back(std::max(*middle / std::log(2.0), 1e-300));
    sum += own / levels.back();
  }
  return sum;
}

/// A line between whole orders is no tooth's, pole's or slot's.
bool has_its_top(const std::vector<MatchedLines>& logs, const std::vector<double>& levels,
                 int order, double here) {
  constexpr int steps = 20;  // to half an order on each side
  double most = here;
  for (int i = -steps; i <= steps; ++i) {
    double sum = 0.0;
    for (std::size_t l = 0; l < logs.size(); ++l)
      sum += logs[l].energy(order + 0.5 * static_cast<double>(i) / steps) / levels[l];
    most = std::max(most, sum);
  }
  return here >= (1.0 - kOffTop) * most - kByNoise;
}

/// Sine and cosine of a line beside its log, whitened, each sample by its weight, in equal blocks
/// of time.
class LineSums {
 public:
  LineSums(const ShaftLog& log, int order, int blocks, const Eigen::ArrayXd& weight)
      : blocks_(blocks), values_(VectorXd::Zero(weight.size())), columns_(values_.size(), 2) {
    const Index n = weight.size();
    const Eigen::ArrayXd angle = 2.0 * std::numbers::pi * order * log.turns.head(n).array();
    MatrixXd all(n, 3);
    all << weight * angle.sin(), weight * angle.cos(), weight * log.value.head(n).array();
    MatrixXd band = to_band(all, n / 2);
    if ((weight == 0.0).all()) return;
    const VectorXd whitening = precision_of(band.col(2), weight.matrix()).cwiseSqrt();
    band = (per_row(whitening).asDiagonal() * band).eval();
    all = from_band(band, n);
    columns_ = all.leftCols(2);
    values_ = all.col(2);
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
  VectorXd values_;
  MatrixXd columns_;
  Eigen::Matrix2d gram_;
  Eigen::Vector2d target_;
};

}  // namespace

std::vector<OrderLine> order_lines(const std::vector<ShaftLog>& logs, int lowest, int highest) {
  std::vector<MatchedLines> matched;
  for (const ShaftLog& log : logs)
    if (MatchedLines lines(log); lines.tells()) matched.push_back(std::move(lines));
  std::vector<OrderLine> found;
  if (matched.empty() || highest < lowest) return found;
  std::vector<double> levels;
  const VectorXd energy = energies(matched, lowest, highest, levels);
  for (int order = lowest; order <= highest; ++order) {
    OrderLine line{order, energy(order - lowest), 1.0};
    // Energies of noise are exponentially distributed.
    line.chance = static_cast<double>(energy.size()) *
                  boost::math::gamma_q(static_cast<double>(matched.size()), line.prominence);
    if (line.chance < kFalseAlarm && has_its_top(matched, levels, order, line.prominence))
      found.push_back(line);
  }
  std::stable_sort(found.begin(), found.end(), [](const OrderLine& a, const OrderLine& b) {
    return a.prominence > b.prominence;
  });
  return found;
}

LineFit fit_line(const ShaftLog& log, int order, int blocks) {
  const Index n = log.turns.size() / 2 * 2;
  Eigen::ArrayXd made = Eigen::ArrayXd::Zero(n);
  made.tail(n - 1) = (log.turns.segment(1, n - 1) - log.turns.head(n - 1)).array().abs();
  const Eigen::ArrayXd weight =
      log.counts.head(n).array() * tells_order(turns_from_reversal(log, n), order);
  const LineSums all(log, order, blocks, weight);
  const LineSums slow(log, order, blocks, (order * made < log.fastest).select(weight, 0.0));
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

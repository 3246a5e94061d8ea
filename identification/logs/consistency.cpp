// SPDX-License-Identifier: GPL-3.0-or-later
// Channels of one coordinate know of one another: the position's derivative is the velocity, a
// measurement follows its reference. Whether an effort fits its motion only the model can tell
// (subjects/column_readings.h).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "identification/logs/data_faults.h"
#include "identification/logs/signal_relations.h"

namespace sinew {
namespace {

using Eigen::ArrayXd;

using std::numbers::pi;

class Group {
 public:
  Group(const Log& log, const std::vector<ChannelSpec>& specs) : log_(log), specs_(specs) {}

  std::map<ChannelRole, int> channel;

  bool has(ChannelRole role) const { return channel.count(role) > 0; }
  int of(ChannelRole role) const { return channel.at(role); }
  const ChannelSpec& spec(ChannelRole role) const { return specs_[static_cast<size_t>(of(role))]; }
  const Channel& info(ChannelRole role) const {
    return log_.channels[static_cast<size_t>(of(role))];
  }

 private:
  const Log& log_;
  const std::vector<ChannelSpec>& specs_;
};

class Checker {
 public:
  Checker(const Log& log, const std::vector<ChannelSpec>& specs, FaultList& faults)
      : log_(log), specs_(specs), faults_(faults) {
    for (size_t s = 1; s < log.segments.size(); ++s)
      if (log.segments[s].samples.rows() > log.segments[longest_].samples.rows()) longest_ = s;
    std::map<int, Group> groups;
    for (size_t i = 0; i < specs.size(); ++i)
      if (specs[i].group >= 0)
        groups.try_emplace(specs[i].group, log, specs).first->second.channel[specs[i].role] =
            static_cast<int>(i);
    for (auto& [number, group] : groups) groups_.push_back(std::move(group));
  }

  void run() {
    if (log_.segments.empty() || samples().rows() < 200) return;
    for (const Group& group : groups_) {
      check_exchanged_effort(group);
      check_velocity(group);
      check_reference(group);
    }
    for (size_t i = 0; i < specs_.size(); ++i) check_range(i);
  }

 private:
  const Eigen::ArrayXXd& samples() const { return log_.segments[longest_].samples; }
  ArrayXd series(int channel) const { return samples().col(channel); }

  void report(FaultKind kind, Severity severity, int channel, const std::string& meaning,
              const std::string& action) {
    const Channel& info = log_.channels[static_cast<size_t>(channel)];
    if (is_reported(channel)) return;
    if (severity == Severity::stop) reported_.push_back(channel);
    faults_.add(kind, severity, log_.segments.front().first_row, log_.segments.front().first_row,
                info.column, info.name, meaning, action);
  }

  void slip(int channel, const UnitSlip& found, const std::string& evidence) {
    const Channel& info = log_.channels[static_cast<size_t>(channel)];
    report(FaultKind::unit_slip, Severity::stop, channel,
           fmt::format("'{}' {}: {}", info.name, evidence, found.meaning),
           fmt::format("units are converted only when told: --map \"{}=#{} [unit]\"", info.name,
                       info.column));
  }

  // ---- one channel against what is possible for it

  void check_range(size_t i) {
    const ChannelSpec& spec = specs_[i];
    const Channel& info = log_.channels[i];
    const double largest = std::max(std::abs(info.low), std::abs(info.high));
    const double allowed = std::max(std::abs(spec.low), std::abs(spec.high));
    if (!std::isfinite(allowed) || allowed <= 0.0) return;
    if (largest > 5.0 * allowed) {
      for (const double factor : {180.0 / pi, 1000.0})
        if (largest / factor < 1.2 * allowed && largest / factor > 1.0e-3 * allowed) {
          const UnitSlip found = unit_slip_of(factor, spec.unit, 0.01);
          if (found.meaning.empty()) continue;
          slip(static_cast<int>(i), found,
               fmt::format("reaches {:.4g} {} where {:.4g} is the limit", largest, spec.unit,
                           allowed));
          return;
        }
    }
    // A lever's count has no unit that a slip is known of.
    constexpr double kNeverThere = 0.005;
    if (spec.required && spec.unit == "1" && largest < kNeverThere * allowed) {
      report(FaultKind::unit_slip, Severity::stop, static_cast<int>(i),
             fmt::format("'{}' never exceeds {:.4g} where the model's sensor goes from {:.4g} to "
                         "{:.4g}: counts taken for something else",
                         info.name, largest, spec.low, spec.high),
             fmt::format("units are converted only when told: --map \"{}=#{} [unit]\"", info.name,
                         info.column));
      return;
    }
    if (info.low < spec.low - 0.25 * allowed || info.high > spec.high + 0.25 * allowed)
      report(FaultKind::out_of_range, Severity::doubtful, static_cast<int>(i),
             fmt::format("'{}' goes from {:.4g} to {:.4g} {}; the model allows {:.4g} to {:.4g}",
                         info.name, info.low, info.high, spec.unit, spec.low, spec.high),
             "the values are kept");
  }

  // ---- position against velocity

  void check_velocity(const Group& group) {
    if (!group.has(ChannelRole::position) || !group.has(ChannelRole::velocity)) return;
    if (is_reported(group.of(ChannelRole::position))) return;
    const ArrayXd p = series(group.of(ChannelRole::position));
    const ArrayXd v = series(group.of(ChannelRole::velocity));
    const auto m = std::max(1L, std::lround(0.01 / log_.period));
    if (p.size() < 20 * m) return;
    const long n = p.size() - 2 * m;
    const double span = 2.0 * static_cast<double>(m) * log_.period;
    const ArrayXd rate = (p.tail(n) - p.head(n)) / span;
    const ArrayXd mean_v = moving_mean(v, m);
    if (rms(centred(p)) < 20.0 * group.info(ChannelRole::position).noise_floor) return;
    const double r = correlation(rate, mean_v);
    if (r < 0.6) {
      const ArrayXd back = (v.tail(n) - v.head(n)) / span;
      if (correlation(back, moving_mean(p, m)) > 0.9) {
        swapped(group.of(ChannelRole::position), group.of(ChannelRole::velocity),
                "the derivative of the second is the first");
        return;
      }
    }
    if (std::abs(r) < 0.6) return;
    // Noise in v lowers the plain slope; the ratio of spreads does not turn with it.
    const double ratio = slope(mean_v, rate);
    judge_ratio(group.of(ChannelRole::velocity), ratio, std::abs(r),
                fmt::format("is {:.4g} times the derivative of '{}'", ratio,
                            group.info(ChannelRole::position).name));
  }

  void judge_ratio(int channel, double ratio, double trust, const std::string& evidence) {
    const Channel& info = log_.channels[static_cast<size_t>(channel)];
    const UnitSlip found = unit_slip_of(std::abs(ratio), info.unit, 0.15);
    if (!found.meaning.empty() && trust > 0.8)
      slip(channel, found, evidence);
    else if (ratio < 0.0 && trust > 0.8)
      report(FaultKind::reversed_sign, Severity::stop, channel,
             fmt::format("'{}' {}: the signs do not belong together", info.name, evidence),
             "the log is not used");
    else if (trust > 0.95 && std::abs(ratio - 1.0) > 0.25)
      report(FaultKind::unit_slip, Severity::doubtful, channel,
             fmt::format("'{}' {}; 1 was expected", info.name, evidence), "the values are kept");
  }

  void swapped(int a, int b, const std::string& evidence) {
    const Channel& first = log_.channels[static_cast<size_t>(a)];
    const Channel& second = log_.channels[static_cast<size_t>(b)];
    report(FaultKind::swapped_columns, Severity::stop, a,
           fmt::format("'{}' (column {}) and '{}' (column {}) are exchanged: {}", first.name,
                       first.column, second.name, second.column, evidence),
           fmt::format("name them rightly: --map \"{}=#{} [unit]\" --map \"{}=#{} [unit]\"",
                       first.name, second.column, second.name, first.column));
    reported_.push_back(b);
  }

  // ---- measured against commanded position

  void check_reference(const Group& group) {
    if (!group.has(ChannelRole::position) || !group.has(ChannelRole::reference)) return;
    const int pc = group.of(ChannelRole::position), rc = group.of(ChannelRole::reference);
    if (is_reported(pc)) return;
    const ArrayXd p = series(pc), r = series(rc);
    if (rms(centred(r)) <= 0.0 || std::abs(correlation(p, r)) < 0.8) return;
    if (is_cut_off(pc, p, r)) return;
    const double ratio = slope(p, r);
    judge_ratio(pc, ratio, std::abs(correlation(p, r)),
                fmt::format("is {:.4g} times its reference '{}'", ratio,
                            group.info(ChannelRole::reference).name));
    if (std::abs(ratio - 1.0) > 0.3) return;
    const ArrayXd lag_base = 0.5 * (r.tail(r.size() - 2) - r.head(r.size() - 2));
    const ArrayXd error = (p - r).segment(1, r.size() - 2);
    const double lag = -slope(error, lag_base);  // samples that the measurement is behind
    const double noise_p = noise_beside_jerks(pc), noise_r = noise_beside_jerks(rc);
    const bool leads = lag < -1.0 && correlation(error, lag_base) > 0.3;
    // A sensor's steps are noise enough, also where a log rests most of the time.
    const bool noise_free =
        std::max(noise_p, noise_r) < 1.0e-6 * rms(centred(r)) && noise_p <= 3.0 * noise_r;
    if ((leads && (noise_free || noise_r > 1.2 * noise_p)) ||
        (lag < 0.5 && noise_r > 3.0 * noise_p))
      swapped(pc, rc,
              fmt::format("the first runs {:.1f} samples ahead of the second, which carries the "
                          "noise of a measurement",
                          -lag));
  }

  // At its limit the measurement stays back behind the reference, and nowhere else.
  bool is_cut_off(int channel, const ArrayXd& p, const ArrayXd& r) {
    ArrayXd size = (r - p).abs();
    std::nth_element(size.data(), size.data() + size.size() / 2, size.data() + size.size());
    const double usual = size(size.size() / 2) + 2.0 * noise_of(channel);
    for (const double limit : {p.maxCoeff(), p.minCoeff()}) {
      const auto there = (p == limit).cast<double>();
      const double count = there.sum();
      const double behind = ((r - p).abs() * there).sum() / std::max(1.0, count);
      if (count < 20.0 || behind < 6.0 * usual) continue;
      const std::string& name = log_.channels[static_cast<size_t>(channel)].name;
      report(FaultKind::clipping, Severity::doubtful, channel,
             fmt::format("'{}' stays at {:.6g} in {} samples while its reference goes on", name,
                         limit, count),
             "the rows are kept");
      return true;
    }
    return false;
  }

  // Mean, not median, of third differences: a coarse encoder at rest most of the time still
  // shows its steps, and a reference made of parabolas shows none.
  double noise_of(int channel) const { return noise_from(third_differences(channel)); }

  // A reference made of parabolas jumps in its acceleration: a few large third differences that
  // are no noise. A sensor's are all over the motion.
  double noise_beside_jerks(int channel) const {
    ArrayXd third = third_differences(channel);
    const auto usual = static_cast<long>(0.97 * static_cast<double>(third.size()));
    std::nth_element(third.data(), third.data() + usual, third.data() + third.size());
    return noise_from(third.head(usual));
  }

  ArrayXd third_differences(int channel) const {
    const auto x = samples().col(channel);
    const long n = x.size() - 3;
    return (x.tail(n) - 3.0 * x.segment(2, n) + 3.0 * x.segment(1, n) - x.head(n)).abs();
  }

  static double noise_from(const ArrayXd& third) {
    return third.mean() / (0.7978845608 * std::sqrt(20.0));
  }

  // Position and effort exchanged: told by the reference or by the velocity.
  void check_exchanged_effort(const Group& group) {
    if (!group.has(ChannelRole::position) || !group.has(ChannelRole::effort)) return;
    const int pc = group.of(ChannelRole::position), ec = group.of(ChannelRole::effort);
    if (group.has(ChannelRole::reference)) {
      const ArrayXd r = series(group.of(ChannelRole::reference));
      if (correlation(series(ec), r) > 0.97 && correlation(series(pc), r) < 0.9) {
        swapped(pc, ec, "the second follows the reference, the first does not");
        return;
      }
    }
    if (!group.has(ChannelRole::velocity)) return;
    const ArrayXd v = series(group.of(ChannelRole::velocity));
    if (rate_correlation(series(ec), v) > 0.95 && rate_correlation(series(pc), v) < 0.8)
      swapped(pc, ec, "the velocity is the derivative of the second");
  }

  double rate_correlation(const ArrayXd& x, const ArrayXd& v) const {
    const auto m = std::max(1L, std::lround(0.01 / log_.period));
    if (x.size() < 20 * m) return 0.0;
    const long n = x.size() - 2 * m;
    return correlation(x.tail(n) - x.head(n), moving_mean(v, m));
  }

  bool is_reported(int channel) const {
    return std::find(reported_.begin(), reported_.end(), channel) != reported_.end();
  }

  const Log& log_;
  const std::vector<ChannelSpec>& specs_;
  FaultList& faults_;
  size_t longest_ = 0;
  std::vector<Group> groups_;
  std::vector<int> reported_;
};

}  // namespace

void judge_consistency(const Log& log, const std::vector<ChannelSpec>& specs, FaultList& faults) {
  Checker(log, specs, faults).run();
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/driven_readings.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include "identification/subjects/column_readings.h"
#include "identification/subjects/driven_equations.h"
#include "identification/subjects/slow_columns.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kOfAnyKind = 30;  // columns, of which each may be exchanged with any other
constexpr double kSilent = 1e9;         // a factor that leaves nothing of a column
constexpr double kSlowest = 5.0;        // clock
constexpr double kLeastClock = 1.4;     // less is what a machine's own values say, and no clock's
constexpr double kMostLeft = 0.5;       // of the efforts' standard deviation: a definition
constexpr int kClocks = 16;             // tried each way

/// By how much a column is too large, by least squares beside what a drive may have of its own.
class Overlap {
 public:
  /// `column` times 1 / factor is `asked`.
  void add(const VectorXd& column, const VectorXd& asked, const MatrixXd& own) {
    const auto qr = own.colPivHouseholderQr();
    const VectorXd a = column - own * qr.solve(column), b = asked - own * qr.solve(asked);
    column_ += a.squaredNorm();
    both_ += a.dot(b);
    asked_ += b.squaredNorm();
  }
  /// What is asked being known exactly.
  double of_noisy_column() const { return both_ / asked_; }
  double of_noisy_asked() const { return column_ / both_; }

 private:
  double column_ = 0.0, both_ = 0.0, asked_ = 0.0;
};

class DrivenJudge {
 public:
  DrivenJudge(const Log& log, const SlowColumns& columns, const DrivenModel& model,
              const DrivenEquations& equations)
      : log_(log), columns_(columns), model_(model), equations_(equations) {
    const Recording as_logged = columns.read_as(nullptr);
    motion_ = equations.logged(as_logged);
    parts_ = equations.parts_of(as_logged, *motion_);
    each_ = equations.evidence_each(parts_);
    as_it_is_ = equations.evidence(parts_);
    as_drawn_ = evidence_of_shares(parts_, equations.left_as_drawn(parts_));
  }

  std::optional<ColumnReading> other_reading() const {
    std::vector<ColumnReading> all = known_slips_of_all();
    add_exchanges(all);
    double could_be = 0.0;
    for (Index i = 0; i < equations_.measured(); ++i) could_be += explained(i);
    if (!is_worth_reading(could_be - as_it_is_, all)) return std::nullopt;
    add_free_factors(all);
    all.push_back(clock());
    std::optional<ColumnReading> found = likelier_reading(
        all, as_it_is_otherwise(all), [&](const ColumnReading& reading, double needed) {
          const double limit = most(reading);
          return limit < needed ? limit : evidence_of_told(reading);
        });
    if (found && is_sign(*found)) add_other_signs(all, *found);
    return found;
  }

  double left_now() const { return left(parts_); }
  double left_by(const ColumnReading& reading) const { return left(parts_of(reading)); }

 private:
  /// A reading that is told explains by itself most of the efforts, and what the log as it is does
  /// not, and not with what the machine may have otherwise alone.
  double evidence_of_told(const ColumnReading& reading) const {
    const std::vector<EffortParts> parts = parts_of(reading);
    const std::vector<double> shares = equations_.left_as_drawn(parts);
    const double left = std::reduce(shares.begin(), shares.end()) / double(shares.size());
    return left < kMostLeft * kMostLeft &&
                   is_worth_reading(evidence_of_shares(parts, shares) - as_drawn_, {reading})
               ? equations_.evidence(parts)
               : -std::numeric_limits<double>::infinity();
  }

  static double evidence_of_shares(const std::vector<EffortParts>& parts,
                                   const std::vector<double>& shares) {
    double sum = 0.0;
    for (std::size_t i = 0; i < parts.size(); ++i) sum += evidence_of_effort(parts[i], shares[i]);
    return sum;
  }

  static double evidence_of_effort(const EffortParts& parts, double left) {
    return evidence_of_share(left, kStretches * parts.moving);
  }

  double evidence(const ColumnReading& reading) const {
    return equations_.evidence(parts_of(reading));
  }

  std::vector<EffortParts> parts_of(const ColumnReading& reading) const {
    const Recording read = columns_.read_as(&reading);
    return has_the_motion(reading) ? equations_.parts_of(read, *motion_)
                                   : equations_.parts_of(read);
  }

  /// Whether positions and loads are those of the log, at whatever pace.
  bool has_the_motion(const ColumnReading& reading) const {
    // A tendon's force is the load of its motor.
    const bool has_motors = columns_.count_of(Quantity::effort) > 0;
    const auto is_effort = [&](int channel) {
      const Quantity quantity = columns_.role_of(channel).quantity;
      return quantity == Quantity::effort || (quantity == Quantity::force && !has_motors);
    };
    return reading.column == ColumnReading::kClock ||
           (is_effort(reading.column) && (reading.other < 0 || is_effort(reading.other)));
  }

  /// Standard deviation.
  static double spread(const VectorXd& x) {
    return std::sqrt((x.array() - x.mean()).square().mean());
  }

  /// Share of the efforts' standard deviation that the model leaves over as it stands.
  static double left(const std::vector<EffortParts>& parts) {
    double total = 0.0;
    for (const EffortParts& p : parts) {
      const VectorXd e = p.measured - p.said;
      if (const double whole = spread(p.measured); whole > 0.0)
        total += std::pow(spread(e) / whole, 2.0);
    }
    return std::sqrt(total / static_cast<double>(parts.size()));
  }

  /// No reading can do better than explain all efforts that it touches, the others each by what
  /// suits it best.
  double most(const ColumnReading& reading) const {
    double sum = 0.0;
    for (Index i = 0; i < equations_.measured(); ++i) {
      // Another column in the place of a position may move more.
      const double best = reading.other < 0 ? explained(i) : evidence_of_share(0.0);
      sum += touches(reading, i) ? best : each_[static_cast<std::size_t>(i)];
    }
    return sum;
  }

  /// Log likelihood of an effort of which nothing is left over where its coordinate moves.
  double explained(Index i) const {
    return evidence_of_effort(parts_[static_cast<std::size_t>(i)], 0.0);
  }

  bool touches(const ColumnReading& reading, Index i) const {
    if (reading.column == ColumnReading::kClock || reading.all) return true;
    const Index first = equations_.by_tendons();
    const auto by = [&](int channel) {
      const ColumnRole& role = columns_.role_of(channel);
      if (role.quantity == Quantity::effort) return i == first + role.at;
      if (role.quantity == Quantity::force) return i < first || i - first == role.at;
      // A motor on a tendon moves nothing but itself.
      if (role.quantity == Quantity::position && first > 0 && role.at >= first) return i == role.at;
      return true;
    };
    return by(reading.column) || (reading.other >= 0 && by(reading.other));
  }

  // ---- how it may have been written

  static bool is_sign(const ColumnReading& reading) {
    return reading.factor == -1.0 && reading.other < 0 && !reading.all;
  }

  /// A lone drive that turns the other way and one that pulls the other way are one log.
  void add_other_signs(const std::vector<ColumnReading>& all, ColumnReading& found) const {
    constexpr double kAlike = 0.1;  // of log likelihood: rounding's and a filter's
    const double own = evidence(found);
    for (const ColumnReading& other : all)
      if (is_sign(other) && other.column != found.column &&
          std::abs(evidence(other) - own) < kAlike)
        found.meaning += fmt::format(", or that of '{}'",
                                     log_.channels[static_cast<std::size_t>(other.column)].name);
  }

  std::vector<ColumnReading> known_slips_of_all() const {
    std::vector<ColumnReading> all;
    for (const ColumnRole& role : columns_.roles()) {
      for (const ColumnReading& slip : known_slips(log_, role.channel)) {
        if (slip.factor > 0.0 && !role.has_unit) continue;
        all.push_back(slip);
        if (!stands_for_all(role)) continue;
        all.push_back(slip);
        all.back().all = true;
      }
      for (const ColumnReading& slip : gear_slips(role)) all.push_back(slip);
    }
    return all;
  }

  bool stands_for_all(const ColumnRole& role) const {
    return role.at == 0 && columns_.count_of(role.quantity) > 1 &&
           (role.quantity == Quantity::effort || role.quantity == Quantity::force);
  }

  std::vector<ColumnReading> gear_slips(const ColumnRole& role) const {
    std::vector<ColumnReading> slips;
    if (role.quantity != Quantity::position && role.quantity != Quantity::effort) return slips;
    if (!role.has_unit) return slips;
    const bool position = role.quantity == Quantity::position;
    const Index first =
        static_cast<Index>(model_.joints.size()) - columns_.count_of(Quantity::effort);
    const DrivenJoint& joint =
        model_.joints[static_cast<std::size_t>(position ? role.at : first + role.at)];
    if (!joint.revolute) return slips;
    if (position)
      slips.push_back({role.channel, -1, 0.5 / std::numbers::pi, "turns taken for radians"});
    if (joint.motor_turn <= 0.0) return slips;
    const double gear = 2.0 * std::numbers::pi / joint.motor_turn;
    slips.push_back(
        {role.channel, -1, position ? gear : 1.0 / gear,
         fmt::format("the motor's {} taken for the output's, the gear's ratio is {:.4g}",
                     position ? "angle" : "torque", gear)});
    return slips;
  }

  void add_exchanges(std::vector<ColumnReading>& all) const {
    const std::vector<ColumnRole>& roles = columns_.roles();
    for (std::size_t a = 0; a < roles.size(); ++a)
      for (std::size_t b = a + 1; b < roles.size(); ++b)
        if (const bool alike = are_alike(roles[a], roles[b]); alike || roles.size() <= kOfAnyKind)
          all.push_back({roles[a].channel, roles[b].channel, 1.0, "", alike ? 1.0 : kRare});
  }

  /// Of one quantity, at joints or at motors.
  bool are_alike(const ColumnRole& a, const ColumnRole& b) const {
    if (a.quantity != b.quantity) return false;
    if (a.quantity != Quantity::position) return true;
    return model_.joints[static_cast<std::size_t>(a.at)].motor ==
           model_.joints[static_cast<std::size_t>(b.at)].motor;
  }

  /// Factors with which what the model says and what is measured go together best.
  void add_free_factors(std::vector<ColumnReading>& all) const {
    for (const ColumnRole& role : columns_.roles()) {
      if (!role.has_unit) continue;
      const std::optional<double> own = free_factor(role, false);
      if (own) all.push_back(times(role.channel, *own, false));
      if (!own || !stands_for_all(role)) continue;
      if (const std::optional<double> common = free_factor(role, true))
        all.push_back(times(role.channel, *common, true));
    }
  }

  static ColumnReading times(int channel, double factor, bool all) {
    return {channel, -1, factor, fmt::format("it is {:.3g} times what the model says", factor),
            kRare,   all};
  }

  std::optional<double> free_factor(const ColumnRole& role, bool all) const {
    Overlap overlap;
    const Index first = equations_.by_tendons();
    for (Index i = 0; i < equations_.measured(); ++i) {
      const EffortParts& p = parts_[static_cast<std::size_t>(i)];
      if (role.quantity == Quantity::effort && i >= first && (all || i == first + role.at))
        overlap.add(p.measured, p.said, p.own);
      if (role.quantity == Quantity::force && i < first) {
        const VectorXd x = all ? VectorXd(p.measured) : VectorXd(p.tendons.col(role.at));
        overlap.add(x, p.said - (p.measured - x), p.own);
      }
      if (role.quantity == Quantity::load && p.load.size() > 0)
        overlap.add(p.load, p.measured - (p.said - p.load), p.own);
    }
    const double factor =
        role.quantity == Quantity::effort ? overlap.of_noisy_column() : overlap.of_noisy_asked();
    const double size = std::abs(factor);
    return size > 1e-4 && size < 1e4 ? std::optional(factor) : std::nullopt;
  }

  /// The likeliest factor of the clock.
  ColumnReading clock() const {
    ColumnReading best{ColumnReading::kClock, -1, 1.0, "", kRare};
    double most_likely = as_it_is_;
    const auto offer = [&](double factor) {
      const ColumnReading reading{ColumnReading::kClock, -1, factor, "", kRare};
      const double here = evidence(reading);
      if (here > most_likely) most_likely = here, best = reading;
    };
    const double least = std::log(kLeastClock), apart = (std::log(kSlowest) - least) / kClocks;
    for (int k = 0; k <= kClocks; ++k)
      for (const double way : {-1.0, 1.0}) offer(std::exp(way * (least + apart * k)));
    for (double near = 0.5 * apart; near > 1e-3; near *= 0.5) {
      const double middle = std::log(best.factor);
      for (const double off : {-near, near})
        if (std::abs(middle + off) >= least) offer(std::exp(middle + off));
    }
    return best;
  }

  /// The log as it is, of a machine whose own constants may be off, or one of whose forces does
  /// something that nobody knows: a reading that makes next to nothing of a column says no more.
  double as_it_is_otherwise(const std::vector<ColumnReading>& all) const {
    double best = as_it_is_;
    const auto offer = [&](const ColumnReading& reading, double price) {
      if (most(reading) - price > best) best = std::max(best, evidence(reading) - price);
    };
    for (const ColumnRole& role : columns_.roles())
      if (role.quantity == Quantity::force) offer({role.channel, -1, kSilent, ""}, 0.0);
    for (const ColumnReading& reading : all) {
      if (reading.factor == 1.0 || reading.column == ColumnReading::kClock ||
          !(reading.factor > 0.0))
        continue;
      const double off = std::log(reading.factor) / kOwnConstant;
      const Index constants =
          reading.all ? columns_.count_of(columns_.role_of(reading.column).quantity) : 1;
      offer(reading, 0.5 * off * off * static_cast<double>(constants));
    }
    return best;
  }

  const Log& log_;
  const SlowColumns& columns_;
  const DrivenModel& model_;
  const DrivenEquations& equations_;
  std::shared_ptr<const DrivenEquations::Logged> motion_;
  std::vector<EffortParts> parts_;  ///< as the log is
  std::vector<double> each_;
  double as_it_is_ = 0.0;
  double as_drawn_ = 0.0;  ///< beside nothing but inertia and friction that the model is without
};

}  // namespace

void judge_driven_columns(const Log& log, const DrivenColumns& columns, const Recording& recording,
                          const DrivenModel& model, const EffortModel& effort,
                          const RigidColumns* rigid, const std::filesystem::path& runtime,
                          FaultList& faults) {
  std::optional<TendonColumns> tendons;
  if (!columns.forces.empty()) tendons.emplace(model, runtime);
  const SlowColumns slow(columns, recording, model, tendons ? &*tendons : nullptr);
  if (!slow.is_long_enough()) return;
  const DrivenEquations equations(model, effort, rigid, static_cast<Index>(columns.efforts.size()));
  if (equations.measured() == 0) return;
  const DrivenJudge judge(log, slow, model, equations);
  const std::optional<ColumnReading> found = judge.other_reading();
  if (found) tell(log, *found, judge.left_by(*found), judge.left_now(), "the efforts", faults);
}

}  // namespace sinew::diagnosis

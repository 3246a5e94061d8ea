// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/lone_consistency.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "identification/subjects/block_regression.h"
#include "identification/subjects/slow_recording.h"

namespace sinew::diagnosis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

// What a joint truly lacks changes its inertia or friction some times over. A factor beyond that is
// a unit's; a smaller one may be, where it is met exactly, or chance.
constexpr double kBeyondPhysics = 20.0, kUnitSpread = 1.6, kExactWithin = 0.03;
constexpr double kWrongBy = 1.4, kLoadWithin = 0.05;  // no load and no clock is off by that much
constexpr double kTimesLess = 10.0, kUnitMostLeft = 0.3, kExactMostLeft = 0.02;

/// A unit that a column may be in: what is logged over what is meant.
struct LoggedUnit {
  bool position = true;
  double factor = 1.0;
  std::string meaning;
  double size() const { return std::max(factor, 1.0 / factor); }
};

std::vector<LoggedUnit> possible_units(const DrivenJoint& joint) {
  std::vector<LoggedUnit> units;
  for (const double factor : {1000.0, 0.001, 180.0 / pi})
    if (const UnitSlip slip = unit_slip_of(factor, joint.revolute ? "rad" : "m", 0.01);
        !slip.meaning.empty())
      units.push_back({true, factor, slip.meaning});
  for (const double factor : {1000.0, 0.001})
    units.push_back(
        {false, factor, unit_slip_of(factor, joint.revolute ? "N*m" : "N", 0.01).meaning});
  if (!joint.revolute) return units;
  units.push_back({true, 0.5 / pi, "turns taken for radians"});
  if (joint.motor_turn <= 0.0) return units;
  const double gear = 2.0 * pi / joint.motor_turn;
  const std::string ratio = fmt::format("the gear's ratio is {:.4g}", gear);
  units.push_back({true, gear, "the motor's angle taken for the output's, " + ratio});
  units.push_back({false, 1.0 / gear, "the motor's torque taken for the output's, " + ratio});
  return units;
}

class LoneJudge {
 public:
  LoneJudge(const Recording& slow, const EffortModel& model) : slow_(slow), model_(model) {}

  /// What the model leaves over where position and effort are divided by these, and the model's
  /// effort may be up to `spread` times larger or smaller.
  double left(double position, double effort, double spread) const {
    const VectorXd said =
        model_(slow_, slow_.q / position, slow_.qd / position, slow_.qdd / position).col(0);
    const VectorXd& measured = slow_.target.front();
    const double square = said.squaredNorm();
    if (!(square > 0.0)) return 1.0;
    const double gain = measured.dot(said) / square;
    return share_left_over(measured, std::clamp(gain, effort / spread, effort * spread) * said);
  }

  /// The same where the log's clock runs `slow` times too slow.
  double left_by_clock(double slow) const {
    return share_left_over(slow_.target.front(),
                           model_(slow_, slow_.q, slow_.qd * slow, slow_.qdd * slow * slow).col(0));
  }

  /// Where one of the model's own values, which acts by this column, is free.
  double left_beside(const MatrixXd& column) const {
    const VectorXd said = model_(slow_, slow_.q, slow_.qd, slow_.qdd).col(0);
    const VectorXd x = column.col(0), rest = slow_.target.front() - said;
    return share_left_over(slow_.target.front(), said + x * (x.dot(rest) / x.squaredNorm()));
  }

  double left(const LoggedUnit& unit, double spread, double off = 1.0) const {
    const double factor = unit.factor * off;
    return unit.position ? left(factor, 1.0, spread) : left(1.0, factor, spread);
  }

  /// It explains nearly all of what the model as it stands does not.
  bool explains(const LoggedUnit& unit) const {
    if (unit.size() > kBeyondPhysics)
      return mends(left(unit, kUnitSpread), left(1.0, 1.0, kUnitSpread), kUnitMostLeft);
    const double here = left(unit, 1.0);
    return mends(here, left(1.0, 1.0, 1.0), kExactMostLeft) &&
           here < left(unit, 1.0, 1.0 + kExactWithin) && here < left(unit, 1.0, 1.0 - kExactWithin);
  }

  static bool mends(double then, double now, double most) {
    return then < most && kTimesLess * then < now;
  }

  const Recording& log() const { return slow_; }

  /// Its effort without the logged load.
  VectorXd without_load() const {
    return model_(slow_, slow_.q, slow_.qd, slow_.qdd).col(0) - slow_.load.col(0);
  }

 private:
  const Recording& slow_;
  const EffortModel& model_;
};

/// The unit that leaves the least, of those that explain.
std::optional<LoggedUnit> unit_slip(const LoneJudge& judge, const DrivenJoint& joint) {
  std::optional<LoggedUnit> best;
  for (const LoggedUnit& unit : possible_units(joint)) {
    if (!judge.explains(unit)) continue;
    if (!best || judge.left(unit, kUnitSpread) < judge.left(*best, kUnitSpread)) best = unit;
  }
  return best;
}

/// What the effort shows of the logged load beside the model's own part, both free: 1 where nothing
/// is wrong. Nothing where the log does not tell it, or where the whole effort is off alike.
std::optional<double> load_shown(const LoneJudge& judge) {
  const Recording& slow = judge.log();
  if (slow.load.size() == 0) return std::nullopt;
  MatrixXd parts(slow.q.rows(), 2);
  parts << slow.load.col(0), judge.without_load();
  BlockRegression regression(2);
  regression.add_joint({slow.qd, slow.qdd, slow.target.front(), {}, {}, {}}, 0, parts);
  const Share shown = regression.shares().front();
  const double size = std::abs(shown.value);
  if (!(size > 0.0) || !(shown.standard_error < kLoadWithin * size)) return std::nullopt;
  if (shown.value > 0.0 && std::max(size, 1.0 / size) < kWrongBy) return std::nullopt;
  const VectorXd& measured = slow.target.front();
  const double of_load = share_left_over(measured, parts.col(1) + shown.value * parts.col(0));
  const double of_all = share_left_over(measured, shown.value * (parts.col(1) + parts.col(0)));
  return of_load < of_all ? std::optional(shown.value) : std::nullopt;
}

/// How much too slow a clock is with which the model explains nearly all; nothing where one value
/// of the model explains as much.
std::optional<double> clock_slip(const LoneJudge& judge) {
  constexpr double most = 5.0;
  constexpr int steps = 160;
  double best = 1.0, least = judge.left_by_clock(1.0);
  const double now = least;
  for (int i = -steps; i <= steps; ++i) {
    const double slow = std::pow(most, static_cast<double>(i) / steps);
    const double left = judge.left_by_clock(slow);
    if (left < least) least = left, best = slow;
  }
  if (std::max(best, 1.0 / best) < kWrongBy) return std::nullopt;
  for (const double otherwise :
       {now, judge.left_beside(judge.log().qdd), judge.left_beside(judge.log().qd)})
    if (!LoneJudge::mends(least, otherwise, kExactMostLeft)) return std::nullopt;
  return best;
}

void judge_load(const Log& log, const DrivenColumns& columns, const LoneJudge& judge,
                FaultList& faults) {
  const std::optional<double> shown = columns.load < 0 ? std::nullopt : load_shown(judge);
  if (!shown) return;
  const Channel& at = log.channels[static_cast<std::size_t>(columns.load)];
  const long row = log.segments.front().first_row;
  faults.add(
      FaultKind::unit_slip, Severity::stop, row, row, at.column, at.name,
      fmt::format("the effort shows {:.4g} times '{}': its unit or its sign", *shown, at.name),
      fmt::format("units are converted only when told: --map \"{}=#{} [unit]\"", at.name,
                  at.column));
}

void judge_clock(const Log& log, const LoneJudge& judge, FaultList& faults) {
  const std::optional<double> slow = clock_slip(judge);
  if (!slow) return;
  const long row = log.segments.front().first_row;
  faults.add(
      FaultKind::time_unit, Severity::stop, row, row, 1, "time",
      fmt::format("'time' seems to run {:.3g} times too {}: with that the model leaves {:.2g} "
                  "% of the effort over, and {:.3g} % as it is",
                  std::max(*slow, 1.0 / *slow), *slow > 1.0 ? "slow" : "fast",
                  100.0 * std::sqrt(judge.left_by_clock(*slow)),
                  100.0 * std::sqrt(judge.left_by_clock(1.0))),
      "units are converted only when told: --map \"time=column [unit]\"");
}

}  // namespace

void judge_lone_effort(const Log& log, const DrivenColumns& columns, const Recording& recording,
                       const EffortModel& model, const DrivenJoint& joint, FaultList& faults) {
  if (columns.positions.size() != 1 || columns.efforts.size() != 1) return;
  const Recording slow = slow_recording(recording);
  if (slow.q.rows() == 0) return;
  const LoneJudge judge(slow, model);
  const std::optional<LoggedUnit> unit = unit_slip(judge, joint);
  if (!unit) {
    judge_load(log, columns, judge, faults);
    if (!faults.stops()) judge_clock(log, judge, faults);
    return;
  }
  const int index = (unit->position ? columns.positions : columns.efforts).front();
  const Channel& at = log.channels[static_cast<std::size_t>(index)];
  const long row = log.segments.front().first_row;
  const bool stop = unit->size() > kBeyondPhysics;
  faults.add(
      FaultKind::unit_slip, stop ? Severity::stop : Severity::doubtful, row, row, at.column,
      at.name,
      fmt::format("'{}' seems {:.4g} times too {}: {}; with that the model leaves {:.2g} % "
                  "of the effort over, and {:.3g} % as it is",
                  at.name, unit->size(), unit->factor > 1.0 ? "large" : "small", unit->meaning,
                  100.0 * std::sqrt(judge.left(*unit, kUnitSpread)),
                  100.0 * std::sqrt(judge.left(1.0, 1.0, 1.0))),
      fmt::format("{}: --map \"{}=#{} [unit]\"",
                  stop ? "units are converted only when told"
                       : "it is taken as it is, a joint may be that much heavier; if it is not",
                  at.name, at.column));
}

}  // namespace sinew::diagnosis

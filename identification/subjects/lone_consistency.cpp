// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/lone_consistency.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "identification/subjects/slow_recording.h"

namespace sinew::diagnosis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

// What a joint truly lacks changes its inertia or friction some times over. A factor beyond that is
// a unit's; a smaller one may be, where it is met exactly, or chance.
constexpr double kBeyondPhysics = 20.0, kUnitSpread = 1.6, kExactWithin = 0.03;
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

 private:
  static bool mends(double then, double now, double most) {
    return then < most && kTimesLess * then < now;
  }

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

}  // namespace

void judge_lone_effort(const Log& log, const DrivenColumns& columns, const Recording& recording,
                       const EffortModel& model, const DrivenJoint& joint, FaultList& faults) {
  if (columns.positions.size() != 1 || columns.efforts.size() != 1) return;
  const Recording slow = slow_recording(recording);
  if (slow.q.rows() == 0) return;
  const LoneJudge judge(slow, model);
  const std::optional<LoggedUnit> unit = unit_slip(judge, joint);
  if (!unit) return;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/tendon_consistency.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

#include "identification/subjects/slow_recording.h"
#include "identification/subjects/tendon_candidates.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What a model lacks is no more than that, or a right column takes it away as little as another; a
// wrong column hides all that the model says rightly.
constexpr double kTendonSuspect = 0.05, kTendonFits = 0.3, kTendonTimesWorse = 10.0;

/// How columns may have been logged: what is done to read them rightly.
struct Rereading {
  FaultKind kind = FaultKind::unit_slip;
  int column = 0, other = -1;  ///< indices of channels; other: exchanged with the first
  std::string meaning;
  bool all = false;  ///< all columns of this kind alike
};

/// The reading that leaves the least, of those that mend.
class BestReading {
 public:
  explicit BestReading(double now) : now_(now), least_(std::numeric_limits<double>::infinity()) {}

  void offer(double left, const std::function<Rereading()>& reading) {
    if (!(left < kTendonFits && kTendonTimesWorse * left < now_ && left < least_)) return;
    least_ = left;
    found_ = reading();
  }
  const std::optional<Rereading>& found() const { return found_; }
  double left() const { return least_; }

 private:
  double now_, least_;
  std::optional<Rereading> found_;
};

/// Share of the torques that the model leaves over, a constant one of each joint apart.
double torques_left(const MatrixXd& torques, const MatrixXd& said) {
  const auto size = [](const MatrixXd& x) {
    return (x.rowwise() - x.colwise().mean()).squaredNorm();
  };
  const double whole = size(torques);
  return whole > 0.0 ? size(torques - said) / whole : 1.0;
}

class TendonJudge {
 public:
  TendonJudge(const Log& log, const DrivenColumns& columns, Recording slow,
              const DrivenModel& model, const EffortModel& effort, FaultList& faults)
      : log_(log),
        columns_(columns),
        slow_(std::move(slow)),
        model_(model),
        effort_(effort),
        faults_(faults),
        joints_(model.tendons.coordinates()),
        tendons_(static_cast<Index>(columns.forces.size())),
        motors_(static_cast<Index>(columns.efforts.size())) {}

  void run(const std::filesystem::path& runtime) {
    look_at_forces(runtime);
    if (!faults_.stops()) look_at_motors();
  }

 private:
  // ---- the forces against the joints' torques

  /// -P^T f, of one tendon's arms and another's force where they are exchanged.
  MatrixXd torque(const Recording& slow, Index arm, Index force) const {
    const MatrixXd& arms = slow.signals.at("moment_arm");
    const VectorXd f = slow.signals.at("tension").col(force);
    return -(arms.middleCols(arm * joints_, joints_).array().colwise() * f.array()).matrix();
  }

  MatrixXd torques(const Recording& slow) const {
    MatrixXd sum = MatrixXd::Zero(slow.q.rows(), joints_);
    for (Index t = 0; t < tendons_; ++t) sum += torque(slow, t, t);
    return sum;
  }

  MatrixXd said(const Recording& slow) const { return effort_(slow).leftCols(joints_); }

  void look_at_forces(const std::filesystem::path& runtime) {
    const MatrixXd measured = torques(slow_), expected = said(slow_);
    const double now = torques_left(measured, expected);
    if (now < kTendonSuspect) return;
    BestReading best(now);
    offer_units(measured, expected, best);
    offer_exchanges(measured, expected, best);
    offer_positions(runtime, best);
    if (best.found()) stop(*best.found(), now, best.left(), "the forces' torques at the joints");
  }

  void offer_units(const MatrixXd& measured, const MatrixXd& expected, BestReading& best) const {
    for (const double factor : {1000.0, 0.001, -1.0}) {
      best.offer(torques_left(measured / factor, expected),
                 [&] { return wrong(columns_.forces.front(), factor, true); });
      for (Index t = 0; t < tendons_; ++t)
        best.offer(torques_left(measured + (1.0 / factor - 1.0) * torque(slow_, t, t), expected),
                   [&] { return wrong(columns_.forces[static_cast<std::size_t>(t)], factor); });
    }
  }

  void offer_exchanges(const MatrixXd& measured, const MatrixXd& expected,
                       BestReading& best) const {
    for (Index a = 0; a < tendons_; ++a)
      for (Index b = a + 1; b < tendons_; ++b)
        best.offer(torques_left(measured + torque(slow_, a, b) + torque(slow_, b, a) -
                                    torque(slow_, a, a) - torque(slow_, b, b),
                                expected),
                   [&] { return exchanged(columns_.forces, a, b); });
  }

  /// Joint angles change the moment arms and what the model says.
  void offer_positions(const std::filesystem::path& runtime, BestReading& best) const {
    const TendonColumns arms(model_, runtime);
    const auto left = [&](const std::function<void(MatrixXd&)>& change) {
      Recording other = slow_;
      for (MatrixXd* x : {&other.q, &other.qd, &other.qdd}) change(*x);
      arms.add_signals(other);
      return torques_left(torques(other), said(other));
    };
    for (Index a = 0; a < joints_; ++a) {
      for (const double factor : {-1.0, 180.0 / std::numbers::pi})
        best.offer(left([&](MatrixXd& x) { x.col(a) /= factor; }),
                   [&] { return wrong(columns_.positions[static_cast<std::size_t>(a)], factor); });
      for (Index b = a + 1; b < joints_; ++b)
        best.offer(left([&](MatrixXd& x) { x.col(a).swap(x.col(b)); }),
                   [&] { return exchanged(columns_.positions, a, b); });
    }
  }

  // ---- the motors' efforts against their motion and their tendons

  /// What the model leaves over of a motor's effort, read from these columns and divided by these.
  double motor_left(Index motor, Index angle, double angle_factor, Index effort,
                    double effort_factor) const {
    Recording other = slow_;
    for (MatrixXd* x : {&other.q, &other.qd, &other.qdd})
      x->col(joints_ + motor) = VectorXd(x->col(joints_ + angle)) / angle_factor;
    const VectorXd expected =
        effort_.of_joint(static_cast<int>(joints_ + motor), other, other.q, other.qd, other.qdd);
    return share_left_over(slow_.target[static_cast<std::size_t>(joints_ + effort)] / effort_factor,
                           expected);
  }

  void look_at_motors() {
    std::vector<Index> suspects;
    for (Index i = 0; i < motors_; ++i) {
      now_.push_back(motor_left(i, i, 1.0, i, 1.0));
      if (now_.back() > kTendonSuspect) suspects.push_back(i);
    }
    for (const Index i : suspects) look_at_motor(i);
    if (faults_.stops()) return;
    for (const Index a : suspects)
      for (const Index b : suspects)
        if (a < b) look_at_pair(a, b);
  }

  int angle(Index i) const { return columns_.positions[static_cast<std::size_t>(joints_ + i)]; }
  int motor_effort(Index i) const { return columns_.efforts[static_cast<std::size_t>(i)]; }

  void look_at_motor(Index i) {
    const double now = now_[static_cast<std::size_t>(i)];
    BestReading best(now);
    for (const double factor : {1000.0, 0.001, -1.0}) {
      best.offer(motor_left(i, i, 1.0, i, factor), [&] { return wrong(motor_effort(i), factor); });
      best.offer(motor_left(i, i, factor, i, 1.0), [&] { return wrong(angle(i), factor); });
    }
    const double degrees = 180.0 / std::numbers::pi;
    best.offer(motor_left(i, i, degrees, i, 1.0), [&] { return wrong(angle(i), degrees); });
    if (best.found()) stop(*best.found(), now, best.left(), "the motor's effort");
  }

  void look_at_pair(Index a, Index b) {
    const double now = now_[static_cast<std::size_t>(a)] + now_[static_cast<std::size_t>(b)];
    BestReading best(now);
    const std::vector<int> angles(columns_.positions.begin() + joints_, columns_.positions.end());
    best.offer(motor_left(a, b, 1.0, a, 1.0) + motor_left(b, a, 1.0, b, 1.0),
               [&] { return exchanged(angles, a, b); });
    best.offer(motor_left(a, a, 1.0, b, 1.0) + motor_left(b, b, 1.0, a, 1.0),
               [&] { return exchanged(columns_.efforts, a, b); });
    if (best.found()) stop(*best.found(), 0.5 * now, 0.5 * best.left(), "the motors' effort");
  }

  // ---- findings

  const Channel& channel(int index) const { return log_.channels[static_cast<std::size_t>(index)]; }

  Rereading wrong(int column, double factor, bool all = false) const {
    if (factor < 0.0) return {FaultKind::reversed_sign, column, -1, "the sign is reversed", all};
    return {FaultKind::unit_slip, column, -1,
            unit_slip_of(factor, channel(column).unit, 0.01).meaning, all};
  }

  static Rereading exchanged(const std::vector<int>& columns, Index a, Index b) {
    return {FaultKind::swapped_columns, columns[static_cast<std::size_t>(a)],
            columns[static_cast<std::size_t>(b)], "", false};
  }

  void stop(const Rereading& found, double now, double then, const std::string& what) {
    const Channel& at = channel(found.column);
    const std::string evidence =
        fmt::format("with that the model leaves {:.2g} % of {} over, and {:.3g} % as it is",
                    100.0 * std::sqrt(then), what, 100.0 * std::sqrt(now));
    const long row = log_.segments.front().first_row;
    if (found.other < 0) {
      faults_.add(found.kind, Severity::stop, row, row, at.column, at.name,
                  fmt::format("'{}'{}: {}; {}", at.name, found.all ? " and all its like" : "",
                              found.meaning, evidence),
                  found.kind == FaultKind::reversed_sign
                      ? "the log is not used"
                      : fmt::format("units are converted only when told: --map \"{}=#{} [unit]\"",
                                    at.name, at.column));
      return;
    }
    const Channel& other = channel(found.other);
    faults_.add(found.kind, Severity::stop, row, row, at.column, at.name,
                fmt::format("'{}' (column {}) and '{}' (column {}) are exchanged: {}", at.name,
                            at.column, other.name, other.column, evidence),
                fmt::format("name them rightly: --map \"{}=#{} [unit]\" --map \"{}=#{} [unit]\"",
                            at.name, other.column, other.name, at.column));
  }

  const Log& log_;
  const DrivenColumns& columns_;
  Recording slow_;
  const DrivenModel& model_;
  const EffortModel& effort_;
  FaultList& faults_;
  Index joints_, tendons_, motors_;
  std::vector<double> now_;
};

}  // namespace

void judge_tendons(const Log& log, const DrivenColumns& columns, const Recording& recording,
                   const DrivenModel& model, const EffortModel& effort,
                   const std::filesystem::path& runtime, FaultList& faults) {
  Recording slow = slow_recording(recording);
  if (slow.q.rows() == 0) return;
  TendonJudge(log, columns, std::move(slow), model, effort, faults).run(runtime);
}

}  // namespace sinew::diagnosis

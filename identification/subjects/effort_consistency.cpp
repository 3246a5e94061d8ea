// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/effort_consistency.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "identification/logs/filter.h"
#include "identification/logs/signal_relations.h"
#include "identification/subjects/slow_recording.h"

namespace sinew::diagnosis {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kCutoff = 10.0;  // Hz
// A model that lacks a payload or friction fits worse than the second, one that reads the right
// columns better; with a wrong column it fits by a multiple worse.
constexpr double kGood = 0.9, kFits = 0.97, kTimesWorse = 10.0;
constexpr double kNoJoint = 20.0;  // times the effort that its model says: another quantity

/// Samples that are looked at: every `stride`th, away from the ends.
struct Thinning {
  Index first = 0, count = 0, stride = 1;

  MatrixXd operator()(const MatrixXd& x) const {
    return x(Eigen::seqN(first, count, stride), Eigen::all);
  }
};

/// The motion and the efforts as they would be if the columns were others.
struct Reading {
  MatrixXd q, qd, qdd;
  MatrixXd measured;  ///< of the judged coordinates

  void scale_motion(Index c, double factor) {
    for (MatrixXd* x : {&q, &qd, &qdd}) x->col(c) *= factor;
  }
  void exchange_motion(Index a, Index b) {
    for (MatrixXd* x : {&q, &qd, &qdd}) x->col(a).swap(x->col(b));
  }
};

/// How the model's effort of a coordinate and the measured one go together, beside friction and an
/// offset.
struct Match {
  double correlation = 0.0;
  double ratio = 0.0;  ///< measured over the model's
};

bool is_good(const Match& m) {
  return m.correlation > kGood && m.ratio > 0.4 && m.ratio < 2.5;
}

bool fits(const Match& m) {
  return is_good(m) && m.correlation > kFits;
}

/// Share of the measured effort that the model leaves over; all of it where the size is wrong.
double left_over(const Match& m) {
  return is_good(m) ? 1.0 - m.correlation * m.correlation : 1.0;
}

class Judge {
 public:
  Judge(const Log& log, const DrivenColumns& columns, const Recording& recording,
        const EffortModel& model, FaultList& faults)
      : log_(log), columns_(columns), model_(model), faults_(faults) {
    count_ = static_cast<Index>(columns.efforts.size());
    first_ = recording.q.cols() - count_;
    const double cutoff = std::min(kCutoff, 0.1 / recording.step);
    const auto end = static_cast<Index>(std::ceil(driven_edge / recording.step));
    const Index rows = recording.q.rows() - 2 * end;
    if (count_ == 0 || recording.q.cols() < 2 || rows < 200) return;
    const Index stride = std::max<Index>(1, rows / kMostPoints);
    const Thinning thinned{end, (rows - 1) / stride + 1, stride};
    MatrixXd measured(recording.q.rows(), count_);
    for (Index i = 0; i < count_; ++i)
      measured.col(i) = recording.target[static_cast<std::size_t>(first_ + i)];
    // Efforts are smoothed as positions are, and may stand for them.
    const Motion motion = differentiate(recording.q, recording.step, cutoff);
    const Motion efforts = differentiate(measured, recording.step, cutoff);
    as_logged_ = {thinned(motion.q), thinned(motion.qd), thinned(motion.qdd), thinned(efforts.q)};
    as_positions_ = {thinned(efforts.q), thinned(efforts.qd), thinned(efforts.qdd)};
    template_.step = recording.step * static_cast<double>(stride);
    template_.time = VectorXd::LinSpaced(thinned.count, 0.0,
                                         template_.step * static_cast<double>(thinned.count - 1));
    if (recording.load.size() > 0) template_.load = thinned(recording.load);
    if (const MatrixXd* tension = recording.signals.find("tension"))
      template_.signals["tension"] = thinned(*tension);
  }

  void run() {
    if (as_logged_.q.rows() == 0) return;
    const MatrixXd efforts = predicted(as_logged_);
    now_ = matches(as_logged_, efforts);
    for (Index i = 0; i < count_; ++i)
      if (!fits(now_[static_cast<std::size_t>(i)])) suspects_.push_back(i);
    if (suspects_.empty()) return;
    look_at_efforts(efforts);
    if (!faults_.stops()) look_at_positions();
  }

 private:
  MatrixXd predicted(const Reading& reading) const {
    return model_(template_, reading.q, reading.qd, reading.qdd).rightCols(count_);
  }

  static Match match(const VectorXd& measured, const VectorXd& model, const ArrayXd& velocity) {
    const double usual = std::max(0.1 * rms(velocity), 1.0e-300);
    MatrixXd friction(velocity.size(), 3);
    friction << VectorXd::Ones(velocity.size()), velocity.matrix(),
        (velocity / usual).tanh().matrix();
    const auto qr = friction.householderQr();
    const auto beside = [&](const VectorXd& x) -> VectorXd { return x - friction * qr.solve(x); };
    const VectorXd a = beside(measured), b = beside(model);
    const double scale = a.norm() * b.norm();
    if (!(scale > 0.0) || !std::isfinite(scale)) return {};
    return {a.dot(b) / scale, a.dot(b) / b.squaredNorm()};
  }

  Match match(const Reading& reading, const MatrixXd& efforts, Index measured, Index at) const {
    return match(reading.measured.col(measured), efforts.col(at),
                 reading.qd.col(first_ + at).array());
  }

  std::vector<Match> matches(const Reading& reading, const MatrixXd& efforts) const {
    std::vector<Match> all;
    for (Index i = 0; i < count_; ++i) all.push_back(match(reading, efforts, i, i));
    return all;
  }

  const Channel& channel(int index) const { return log_.channels[static_cast<std::size_t>(index)]; }
  const Channel& effort(Index i) const {
    return channel(columns_.efforts[static_cast<std::size_t>(i)]);
  }
  const Channel& position(Index i) const {
    return channel(columns_.positions[static_cast<std::size_t>(first_ + i)]);
  }

  void stop(FaultKind kind, const Channel& at, const std::string& meaning,
            const std::string& action) {
    const long row = log_.segments.front().first_row;
    faults_.add(kind, Severity::stop, row, row, at.column, at.name, meaning, action);
  }

  void exchanged(const Channel& a, const Channel& b, const std::string& evidence) {
    stop(FaultKind::swapped_columns, a,
         fmt::format("'{}' (column {}) and '{}' (column {}) are exchanged: {}", a.name, a.column,
                     b.name, b.column, evidence),
         fmt::format("name them rightly: --map \"{}=#{} [unit]\" --map \"{}=#{} [unit]\"", a.name,
                     b.column, b.name, a.column));
  }

  void look_at_efforts(const MatrixXd& efforts) {
    for (const Index i : suspects_) {
      const Match& m = now_[static_cast<std::size_t>(i)];
      const Channel& e = effort(i);
      if (m.correlation < -kGood)
        stop(FaultKind::reversed_sign, e,
             fmt::format("'{}' is {:.3g} times what the model says of this motion: one of '{}' and "
                         "'{}' has the wrong sign",
                         e.name, m.ratio, e.name, position(i).name),
             "the log is not used");
      if (m.correlation < kGood) continue;
      const UnitSlip slip = unit_slip_of(m.ratio, e.unit, 0.5);
      if (!slip.meaning.empty())
        stop(FaultKind::unit_slip, e,
             fmt::format("'{}' is {:.3g} times what the model says of this motion: {}", e.name,
                         m.ratio, slip.meaning),
             fmt::format("units are converted only when told: --map \"{}=#{} [unit]\"", e.name,
                         e.column));
      else if (std::max(m.ratio, 1.0 / m.ratio) > kNoJoint)
        stop(FaultKind::unit_slip, e,
             fmt::format(
                 "'{}' is {:.3g} times what the model says of this motion: {}", e.name, m.ratio,
                 m.ratio < 1.0 ? fmt::format("the torque of a motor in front of a gear of "
                                             "about {:.0f}, or another unit",
                                             1.0 / m.ratio)
                               : std::string("no joint is that much heavier, another unit")),
             "the log is not used: give the effort at the joint, in N*m or N");
    }
    for (const auto& [a, b] : suspect_pairs()) {
      std::vector<Match> then = now_;
      then[static_cast<std::size_t>(a)] = match(as_logged_, efforts, b, a);
      then[static_cast<std::size_t>(b)] = match(as_logged_, efforts, a, b);
      if (mends(then, {a, b}))
        exchanged(effort(a), effort(b), "each is the effort of the other's joint");
    }
  }

  /// Whether that explains many times more at the joints it concerns, and elsewhere no less.
  bool mends(const Reading& reading, std::initializer_list<Index> joints) const {
    return mends(matches(reading, predicted(reading)), joints);
  }

  bool mends(const std::vector<Match>& then, std::initializer_list<Index> joints) const {
    double before = 0.0, after = 0.0;
    for (const Index i : joints) {
      const auto k = static_cast<std::size_t>(i);
      if (!is_good(then[k])) return false;
      before += left_over(now_[k]);
      after += left_over(then[k]);
    }
    if (kTimesWorse * after > before) return false;
    double change = 0.0;
    for (std::size_t k = 0; k < then.size(); ++k) change += left_over(then[k]) - left_over(now_[k]);
    return change < 0.0;
  }

  void look_at_positions() {
    for (const Index i : suspects_) {
      Reading turned = as_logged_;
      turned.scale_motion(first_ + i, -1.0);
      if (mends(turned, {i})) {
        stop(FaultKind::reversed_sign, position(i),
             fmt::format("the efforts fit the model's where '{}' has the other sign, and not as it "
                         "is",
                         position(i).name),
             "the log is not used");
        return;
      }
      Reading other = as_logged_;
      other.q.col(first_ + i) = as_positions_.q.col(i);
      other.qd.col(first_ + i) = as_positions_.qd.col(i);
      other.qdd.col(first_ + i) = as_positions_.qdd.col(i);
      other.measured.col(i) = as_logged_.q.col(first_ + i);
      if (mends(other, {i})) {
        exchanged(position(i), effort(i), "the model fits the other way round, and not as it is");
        return;
      }
      if (position(i).unit != "rad") continue;
      Reading degrees = as_logged_;
      degrees.scale_motion(first_ + i, std::numbers::pi / 180.0);
      if (mends(degrees, {i})) {
        stop(FaultKind::unit_slip, position(i),
             fmt::format("'{}': degrees taken for radians, with which the efforts fit the model's",
                         position(i).name),
             fmt::format("units are converted only when told: --map \"{}=#{} [unit]\"",
                         position(i).name, position(i).column));
        return;
      }
    }
    for (const auto& [a, b] : suspect_pairs()) {
      Reading other = as_logged_;
      other.exchange_motion(first_ + a, first_ + b);
      if (!mends(other, {a, b})) continue;
      exchanged(position(a), position(b),
                "the efforts fit the model's the other way round, and not as it is");
      return;
    }
  }

  /// One of the two does not fit.
  std::vector<std::pair<Index, Index>> suspect_pairs() const {
    std::vector<std::pair<Index, Index>> pairs;
    for (Index a = 0; a < count_; ++a)
      for (Index b = a + 1; b < count_; ++b)
        if (!fits(now_[static_cast<std::size_t>(a)]) || !fits(now_[static_cast<std::size_t>(b)]))
          pairs.emplace_back(a, b);
    return pairs;
  }

  const Log& log_;
  const DrivenColumns& columns_;
  const EffortModel& model_;
  FaultList& faults_;
  Index count_ = 0;  ///< judged coordinates: the last of all
  Index first_ = 0;
  Reading as_logged_;
  Motion as_positions_;  ///< the measured efforts, as if they were positions
  Recording template_;
  std::vector<Match> now_;
  std::vector<Index> suspects_;
};

}  // namespace

void judge_efforts(const Log& log, const DrivenColumns& columns, const Recording& recording,
                   const EffortModel& model, FaultList& faults) {
  Judge(log, columns, recording, model, faults).run();
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/rig_readings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "identification/subjects/column_readings.h"
#include "identification/subjects/slow_recording.h"
#include "identification/subjects/tendon_candidates.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Limit of a radius, times the drawn one, as of the effect (symbolic/extension/wrist_effects.cpp).
constexpr double kLargest = 2.0;

/// Of one sensor: the share of its variance that the model leaves over, and by how much the model's
/// motion of it would have to be larger for the least of it.
struct SensorMatch {
  double as_it_is = 1.0, scaled = 1.0, gain = 1.0;
};

SensorMatch match_of(const VectorXd& measured, const VectorXd& said) {
  const VectorXd y = measured.array() - measured.mean(), m = said.array() - said.mean();
  const double whole = y.squaredNorm(), moved = m.squaredNorm();
  if (!(whole > 0.0) || !(moved > 0.0) || !std::isfinite(moved)) return {};
  const double gain = y.dot(m) / moved;
  return {(y - m).squaredNorm() / whole, (y - gain * m).squaredNorm() / whole, gain};
}

/// Log likelihood of a sensor, its gain free as far as a drawing is.
double evidence_of(const SensorMatch& match) {
  const double as_it_is = evidence_of_share(match.as_it_is);
  if (!(match.gain > 1.0 / kLargest && match.gain < kLargest)) return as_it_is;
  const double off = std::log(match.gain) / kDrawnArm;
  return std::max(as_it_is, evidence_of_share(match.scaled) - 0.5 * off * off);
}

class RigJudge {
 public:
  RigJudge(const Log& log, const ObservedRig& rig, const ObservedSubject& subject)
      : log_(log), rig_(rig), subject_(subject) {
    const auto longest = std::max_element(
        log.segments.begin(), log.segments.end(),
        [](const auto& a, const auto& b) { return a.samples.rows() < b.samples.rows(); });
    const Index stride = (longest->samples.rows() - 1) / kMostPoints + 1;
    const Index rows = (longest->samples.rows() - 1) / stride + 1;
    whole_.start = longest->start;
    whole_.samples = longest->samples(Eigen::seqN(0, rows, stride), Eigen::all);
    thinned_.file = log.file;
    thinned_.channels = log.channels;
    thinned_.period = log.period * static_cast<double>(stride);
    thinned_.segments = {whole_};
    const Recording recording = recorded(whole_);
    for (std::size_t c = 0; c < log.channels.size(); ++c)
      if (recording.signals.find(log.channels[c].name) || is_sensor(log.channels[c].name))
        columns_.push_back(static_cast<int>(c));
    now_ = matches(whole_);
    as_logged_ = sum_of(now_);
  }

  /// The likeliest other reading, where it is likelier than the log as it is.
  std::optional<ColumnReading> other_reading() const {
    const std::vector<ColumnReading> all = readings();
    const double most = static_cast<double>(now_.size()) * evidence_of_share(0.0);
    if (!is_worth_reading(most - as_logged_, all)) return std::nullopt;
    return likelier_reading(all, as_logged_, [&](const ColumnReading& reading, double) {
      return sum_of(matches(read_as(reading)));
    });
  }

  /// Share of the sensors' motion.
  double left_now() const { return left(now_); }
  double left_by(const ColumnReading& reading) const { return left(matches(read_as(reading))); }

 private:
  bool is_sensor(const std::string& name) const {
    return std::any_of(rig_.channels.begin(), rig_.channels.end(),
                       [&](const ObservedChannel& c) { return c.name == name; });
  }

  Recording recorded(const sinew::Segment& segment) const {
    return rig_.recording(thinned_, segment, subject_.open());
  }

  std::vector<SensorMatch> matches(const sinew::Segment& segment) const {
    const Recording recording = recorded(segment);
    const MatrixXd said = subject_.open()(recording, subject_.learnt(), subject_.shapes());
    std::vector<SensorMatch> all;
    // A lever's elongation may be said and not logged.
    for (std::size_t c = 0; c < recording.target.size(); ++c)
      all.push_back(match_of(recording.target[c], said.col(static_cast<Index>(c))));
    return all;
  }

  static double sum_of(const std::vector<SensorMatch>& matches) {
    double sum = 0.0;
    for (const SensorMatch& match : matches) sum += evidence_of(match);
    return sum;
  }

  static double left(const std::vector<SensorMatch>& matches) {
    double sum = 0.0;
    for (const SensorMatch& match : matches) sum += match.as_it_is;
    return std::sqrt(sum / static_cast<double>(matches.size()));
  }

  sinew::Segment read_as(const ColumnReading& reading) const {
    sinew::Segment other = whole_;
    other.samples.col(reading.column) /= reading.factor;
    if (reading.other >= 0)
      other.samples.col(reading.column).swap(other.samples.col(reading.other));
    return other;
  }

  std::vector<ColumnReading> readings() const {
    std::vector<ColumnReading> all;
    for (const int column : columns_) {
      for (const ColumnReading& slip : known_slips(log_, column)) all.push_back(slip);
      const std::string& name = log_.channels[static_cast<std::size_t>(column)].name;
      for (std::size_t c = 0; c < rig_.channels.size(); ++c)
        if (rig_.channels[c].name == name && now_[c].gain != 0.0)
          all.push_back({column, -1, now_[c].gain,
                         fmt::format("it is {:.3g} times what the model says", now_[c].gain),
                         kRare});
    }
    for (std::size_t a = 0; a < columns_.size(); ++a)
      for (std::size_t b = a + 1; b < columns_.size(); ++b)
        all.push_back({columns_[a], columns_[b], 1.0, ""});
    return all;
  }

  const Log& log_;
  const ObservedRig& rig_;
  const ObservedSubject& subject_;
  Log thinned_;
  sinew::Segment whole_;  ///< the longest one, thinned
  std::vector<int> columns_;
  std::vector<SensorMatch> now_;
  double as_logged_ = 0.0;
};

}  // namespace

void judge_rig_columns(const Log& log, const ObservedRig& rig, const ObservedSubject& subject,
                       FaultList& faults) {
  const auto is_long = [&](const sinew::Segment& s) {
    return s.samples.rows() >= shortest_segment(log.period);
  };
  if (std::none_of(log.segments.begin(), log.segments.end(), is_long)) return;
  const RigJudge judge(log, rig, subject);
  const std::optional<ColumnReading> found = judge.other_reading();
  if (found)
    tell(log, *found, judge.left_by(*found), judge.left_now(), "the sensors' motion", faults);
}

}  // namespace sinew::diagnosis

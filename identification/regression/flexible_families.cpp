// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/flexible_families.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace sinew::diagnosis {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

constexpr const char* kPeriodically = "position, periodically";
constexpr double kRest = 1e-2;  // share of the top speed below which the direction is undecided

ArrayXd direction(const Recording& log, int axis, double soft) {
  return (log.qd.col(axis).array() / soft).tanh();
}

/// Both from one call: a search over periods does little else.
MatrixXd sine_and_cosine(const VectorXd& angle) {
  MatrixXd x(angle.size(), 2);
  for (Index k = 0; k < angle.size(); ++k) sincos(angle(k), &x(k, 0), &x(k, 1));
  return x;
}

Candidate unnamed(CandidateKind kind, const std::string& depends_on, int axis, int channel) {
  Candidate c;
  c.name = "any dependence on " + depends_on;
  c.place = "axis " + std::to_string(axis + 1);
  c.kind = kind;
  c.depends_on = depends_on;
  c.channels = {channel};
  return c;
}

/// What a coefficient is one for.
enum class OneFor { all_logs, each_log, each_stretch };

void add_coefficients(Candidate& c, int count, OneFor one = OneFor::all_logs) {
  for (int k = 0; k < count; ++k) {
    LinearParameter p;
    p.name = std::string("b").append(std::to_string(k));
    p.per_log = one != OneFor::all_logs;
    p.per_stretch = one == OneFor::each_stretch;
    c.linear.push_back(p);
  }
}

/// Splines in one variable, times the direction where `soft` is not 0.
Candidate spline_family(Candidate c, const LogSignal& values, double low, double high, int count,
                        int axis, double soft) {
  add_coefficients(c, count);
  c.columns = [=](const Recording& log, int, const VectorXd&) {
    MatrixXd basis = spline_basis(values(log), low, high, count);
    if (soft > 0.0) basis = direction(log, axis, soft).matrix().asDiagonal() * basis;
    return basis;
  };
  return c;
}

/// Products of splines in position and in velocity.
Candidate position_and_velocity(const FlexibleRanges& r, int axis, int channel) {
  Candidate c = unnamed(CandidateKind::flexible, "position and velocity together", axis, channel);
  constexpr int each = 5;
  add_coefficients(c, each * each);
  c.columns = [r, axis](const Recording& log, int, const VectorXd&) {
    const MatrixXd a = spline_basis(log.q.col(axis), r.low, r.high, each);
    const MatrixXd b = spline_basis(log.qd.col(axis), -r.speed, r.speed, each);
    MatrixXd x(a.rows(), each * each);
    for (Index i = 0; i < each; ++i)
      for (Index k = 0; k < each; ++k) x.col(i * each + k) = a.col(i).cwiseProduct(b.col(k));
    return x;
  };
  return c;
}

/// Friction by position and load together: products of splines in both.
Candidate position_and_load(const FlexibleRanges& r, double soft, int axis, int channel) {
  Candidate c =
      unnamed(CandidateKind::flexible, "position and load together x direction", axis, channel);
  constexpr int each = 5;
  add_coefficients(c, each * each);
  c.columns = [r, soft, axis](const Recording& log, int, const VectorXd&) {
    const MatrixXd a = spline_basis(log.q.col(axis), r.low, r.high, each);
    const MatrixXd b = spline_basis(log.load.col(axis), -r.load, r.load, each);
    const VectorXd turn = direction(log, axis, soft).matrix();
    MatrixXd x(a.rows(), each * each);
    for (Index i = 0; i < each; ++i)
      for (Index k = 0; k < each; ++k)
        x.col(i * each + k) = a.col(i).cwiseProduct(b.col(k)).cwiseProduct(turn);
    return x;
  };
  return c;
}

/// |velocity| through a low-pass of that time constant, from rest at a log's start [s].
VectorXd recent_speed(const Recording& log, int axis, double time_constant) {
  VectorXd recent(log.qd.rows());
  const double share = 1.0 - std::exp(-log.step / time_constant);
  double value = 0.0;
  for (Index k = 0; k < recent.size(); ++k)
    recent(k) = value += share * (std::abs(log.qd(k, axis)) - value);
  return recent;
}

/// Friction that motion wears down or builds up, and that recovers within a time of its own.
Candidate by_recent_speed(const FlexibleRanges& r, double soft, bool by_direction, int axis,
                          int channel) {
  Candidate c =
      unnamed(CandidateKind::flexible,
              by_direction ? "recent speed x direction" : "recent speed x velocity", axis, channel);
  constexpr int count = 6;
  c.nonlinear = {{"time constant", "s", 0.2, 10.0, 4, true}};
  add_coefficients(c, count);
  c.columns = [r, soft, by_direction, axis](const Recording& log, int, const VectorXd& p) {
    const MatrixXd basis = spline_basis(recent_speed(log, axis, p(0)), 0.0, r.speed, count);
    const VectorXd turn =
        by_direction ? VectorXd(direction(log, axis, soft)) : VectorXd(log.qd.col(axis));
    return MatrixXd(turn.asDiagonal() * basis);
  };
  return c;
}

/// A level of its own for every stroke between two reversals; where there are more strokes than
/// columns neighbours share one.
Candidate stroke_by_stroke(double rest, int stretches, bool by_direction, int axis, int channel) {
  Candidate c = unnamed(CandidateKind::flexible,
                        by_direction ? "the stroke x direction" : "the stroke", axis, channel);
  constexpr int of_all = 40, least = 2;
  const int most = std::max(least, of_all / std::max(1, stretches));
  add_coefficients(c, most, OneFor::each_stretch);
  c.columns = [=](const Recording& log, int, const VectorXd&) {
    const std::vector<int> strokes = stroke_numbers(log.qd.col(axis), rest);
    const int count = strokes.empty() ? 1 : strokes.back() + 1;
    const ArrayXd turn = direction(log, axis, rest);
    MatrixXd x = MatrixXd::Zero(log.qd.rows(), most);
    for (Index k = 0; k < x.rows(); ++k) {
      const int stroke = strokes[static_cast<std::size_t>(k)];
      x(k, count > most ? stroke * most / count : stroke) = by_direction ? turn(k) : 1.0;
    }
    return x;
  };
  return c;
}

/// Sine and cosine of any period in position, from two turns over the range to what is visible.
Candidate any_period_in_position(const FlexibleRanges& r, int axis, int channel) {
  Candidate c = unnamed(CandidateKind::flexible, kPeriodically, axis, channel);
  c.name = "any period in position";
  c.nonlinear = {visible_periods(r)};
  add_coefficients(c, 2, OneFor::each_log);
  c.columns = [axis](const Recording& log, int, const VectorXd& p) {
    return sine_and_cosine(2.0 * pi * p(0) * log.q.col(axis));
  };
  return c;
}

/// Friction that waxes and wanes: from one swing over the log to thirty.
Candidate any_swing_of_friction(const FlexibleRanges& r, double soft, int axis, int channel) {
  Candidate c = unnamed(CandidateKind::flexible, "time, periodically x direction", axis, channel);
  c.name = "friction swinging at any rate";
  c.nonlinear = {{"swings per second", "Hz", 1.0 / r.duration, 30.0 / r.duration, 58, false}};
  add_coefficients(c, 2, OneFor::each_log);
  c.columns = [axis, soft](const Recording& log, int, const VectorXd& p) {
    return MatrixXd(direction(log, axis, soft).matrix().asDiagonal() *
                    sine_and_cosine(2.0 * pi * p(0) * log.time));
  };
  return c;
}

/// A force beyond a position: side +1 above it, -1 below.
Candidate beyond_a_position(const FlexibleRanges& r, int side, int axis, int channel) {
  Candidate c = unnamed(CandidateKind::decoy,
                        side > 0 ? "position, only above a place" : "position, only below a place",
                        axis, channel);
  c.name = side > 0 ? "force beyond a position, above" : "force beyond a position, below";
  const double reach = r.high - r.low;
  c.nonlinear = {{"place", "", side > 0 ? r.low + 0.4 * reach : r.low + 0.03 * reach,
                  side > 0 ? r.high - 0.03 * reach : r.high - 0.4 * reach, 8, false}};
  add_coefficients(c, 1);
  c.columns = [axis, side](const Recording& log, int, const VectorXd& p) {
    return MatrixXd((side * (log.q.col(axis).array() - p(0))).max(0.0).matrix());
  };
  return c;
}

Candidate at_one_place(const FlexibleRanges& r, int axis, int channel) {
  Candidate c = unnamed(CandidateKind::decoy, "position, at one place", axis, channel);
  c.name = "force at one place";
  const double reach = r.high - r.low;
  c.nonlinear = {{"place", "", r.low, r.high, 20, false},
                 {"width", "", 0.03 * reach, 0.25 * reach, 3, true}};
  add_coefficients(c, 1);
  c.columns = [axis](const Recording& log, int, const VectorXd& p) {
    const ArrayXd away = (log.q.col(axis).array() - p(0)) / p(1);
    return MatrixXd((-away.square()).exp().matrix());
  };
  return c;
}

}  // namespace

MatrixXd spline_basis(const VectorXd& x, double low, double high, int count) {
  const int intervals = std::max(1, count - 3);
  MatrixXd basis = MatrixXd::Zero(x.size(), count);
  for (Index i = 0; i < x.size(); ++i) {
    const double u = std::clamp((x(i) - low) / (high - low), 0.0, 1.0) * intervals;
    const int k = std::min(static_cast<int>(u), intervals - 1);
    const double t = u - k, r = 1.0 - t;
    const double weights[4] = {r * r * r / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
                               (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0,
                               t * t * t / 6.0};
    for (int j = 0; j < 4 && k + j < count; ++j) basis(i, k + j) = weights[j];
  }
  return basis;
}

Candidate any_law(const std::string& depends_on, const LogSignal& values, double low, double high,
                  int axis, int channel) {
  constexpr int count = 8;
  return spline_family(unnamed(CandidateKind::flexible, depends_on, axis, channel), values, low,
                       high, count, axis, 0.0);
}

Candidate changing_in_time(const std::string& depends_on, const LogSignal& term, double duration,
                           int axis, int channel) {
  constexpr int count = 5;
  Candidate c = unnamed(CandidateKind::flexible, depends_on, axis, channel);
  add_coefficients(c, count);
  c.of_its_time = true;
  c.columns = [=](const Recording& log, int, const VectorXd&) {
    const VectorXd time = log.time.array() - log.started();
    return MatrixXd(term(log).asDiagonal() * spline_basis(time, 0.0, duration, count));
  };
  return c;
}

VectorXd way_since_reversal(const VectorXd& position, const VectorXd& velocity, double rest) {
  VectorXd way(position.size());
  double turned_at = position.size() ? position(0) : 0.0, furthest = turned_at;
  int side = 0;
  for (Index i = 0; i < position.size(); ++i) {
    const int now = velocity(i) > rest ? 1 : velocity(i) < -rest ? -1 : 0;
    if (now != 0 && now != side) {
      if (side != 0) turned_at = furthest;
      side = now;
      furthest = position(i);
    }
    if (side * (position(i) - furthest) > 0.0) furthest = position(i);
    way(i) = std::abs(position(i) - turned_at);
  }
  return way;
}

std::vector<int> stroke_numbers(const VectorXd& velocity, double rest) {
  std::vector<int> number(static_cast<std::size_t>(velocity.size()));
  int side = 0, stroke = 0;
  for (Index k = 0; k < velocity.size(); ++k) {
    const int now = velocity(k) > rest ? 1 : velocity(k) < -rest ? -1 : 0;
    if (now != 0 && side != 0 && now != side) ++stroke;
    if (now != 0) side = now;
    number[static_cast<std::size_t>(k)] = stroke;
  }
  return number;
}

NonlinearParameter visible_periods(const FlexibleRanges& r) {
  const double reach = r.high - r.low;
  // Faster than 50 Hz at half the top speed would be out of the band.
  const double most = std::max(4.0, std::min(80.0, 100.0 * reach / r.speed));
  return {
      "turns per unit", "", 2.0 / reach, most / reach, static_cast<int>(2.0 * (most - 2.0)), false};
}

std::vector<Candidate> flexible_families(const FlexibleRanges& r, int axis, int channel) {
  const double soft = kRest * r.speed;
  std::vector<Candidate> list;
  const auto add = [&](const std::string& on, bool by_direction, const LogSignal& values,
                       double low, double high, int count) {
    if (high > low)
      list.push_back(spline_family(unnamed(CandidateKind::flexible, on, axis, channel), values, low,
                                   high, count, axis, by_direction ? soft : 0.0));
  };
  const LogSignal position = [axis](const Recording& log) { return VectorXd(log.q.col(axis)); };
  const LogSignal velocity = [axis](const Recording& log) { return VectorXd(log.qd.col(axis)); };
  const LogSignal load = [axis](const Recording& log) { return VectorXd(log.load.col(axis)); };
  const LogSignal time = [](const Recording& log) {
    return VectorXd(log.time.array() - log.started());
  };
  const double reach = r.high - r.low;
  const LogSignal way = [axis, soft, reach](const Recording& log) {
    const VectorXd w = way_since_reversal(log.q.col(axis), log.qd.col(axis), soft);
    return VectorXd((w.array() / reach).sqrt());
  };
  add("position", false, position, r.low, r.high, 12);
  add("position x direction", true, position, r.low, r.high, 12);
  add("velocity", false, velocity, -r.speed, r.speed, 14);
  for (const bool by_direction : {false, true}) {
    add(by_direction ? "time x direction" : "time", by_direction, time, 0.0, r.duration, 10);
    list.back().of_its_time = true;
  }
  add("load", false, load, -r.load, r.load, 8);
  add("load x direction", true, load, -r.load, r.load, 8);
  if (!(reach > 0.0 && r.speed > 0.0)) return list;
  add("way since the last reversal x direction", true, way, 0.0, 1.0, 8);
  list.push_back(position_and_velocity(r, axis, channel));
  if (r.load > 0.0) list.push_back(position_and_load(r, soft, axis, channel));
  list.push_back(stroke_by_stroke(soft, r.stretches, false, axis, channel));
  list.push_back(stroke_by_stroke(soft, r.stretches, true, axis, channel));
  for (const bool by_direction : {true, false})
    list.push_back(by_recent_speed(r, soft, by_direction, axis, channel));
  list.push_back(any_period_in_position(r, axis, channel));
  list.push_back(any_swing_of_friction(r, soft, axis, channel));
  return list;
}

bool is_periodic_in_position(const Candidate& c) {
  return c.depends_on == kPeriodically;
}

std::vector<Candidate> varying_values(const FlexibleRanges& r, int axis, int channel) {
  if (!(r.effort > 0.0)) return {};
  const LogSignal effort = [axis](const Recording& log) {
    return VectorXd(log.signals.at("effort").col(axis));
  };
  const LogSignal acceleration = [axis](const Recording& log) {
    return VectorXd(log.qdd.col(axis));
  };
  return {any_law("the model's effort", effort, -r.effort, r.effort, axis, channel),
          changing_in_time("time x the model's effort", effort, r.duration, axis, channel),
          changing_in_time("time x acceleration", acceleration, r.duration, axis, channel)};
}

std::vector<Candidate> local_decoys(const FlexibleRanges& r, int axis, int channel) {
  if (!(r.high > r.low)) return {};
  return {at_one_place(r, axis, channel), beyond_a_position(r, 1, axis, channel),
          beyond_a_position(r, -1, axis, channel)};
}

}  // namespace sinew::diagnosis

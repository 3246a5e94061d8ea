// SPDX-License-Identifier: GPL-3.0-or-later
// A spring-loaded lever and its tendon on a calibration rig: the tendon is drawn slowly, a load
// cell at its end and the lever's sensor are logged. The geometry is worked out here by itself.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/blind/truth/plant.h"
#include "tests/blind/truth/signals.h"

namespace sinew::truth {
namespace {

constexpr double pi = 3.14159265358979323846;

struct Point {
  double x = 0.0, y = 0.0;
};

struct LeverModel {
  double stiffness = 6400.0;  ///< N/m of the spring
  double motor_radius = 0.005, lever_radius = 0.004, fixed_radius = 0.004;
  Point motor{0.0, 0.0}, fixed{0.034, 0.0}, pivot{0.005, -0.005}, anchor{0.025, -0.017};
  double arm = 0.014, spring_arm = 0.015, spring_angle = -130.0 * pi / 180.0;
  double rest = 48.0 * pi / 180.0;  ///< the spring is free here
  double reach = 9.5e-3;            ///< usual elongation, m
};

// One straight run between two round pulleys, touched on the given sides.
struct Run {
  double length, direction;
};

Run run_between(Point a, double side_radius_a, Point b, double side_radius_b) {
  const double dx = b.x - a.x, dy = b.y - a.y, k = side_radius_a - side_radius_b;
  const double length = std::sqrt(dx * dx + dy * dy - k * k);
  return {length, std::atan2(dy, dx) + std::atan2(k, length)};
}

Point lever_pulley(const LeverModel& m, double angle) {
  return {m.pivot.x + m.arm * std::cos(angle), m.pivot.y + m.arm * std::sin(angle)};
}

// Tendon from the motor pulley to the fixed one; straight parts and arcs, up to a constant.
double path_length(const LeverModel& m, double angle) {
  const Point c = lever_pulley(m, angle);
  const double r1 = m.motor_radius, r2 = -m.lever_radius, r3 = m.fixed_radius;
  const Run first = run_between(m.motor, r1, c, r2), second = run_between(c, r2, m.fixed, r3);
  return first.length + second.length + r1 * first.direction +
         r2 * (second.direction - first.direction) - r3 * second.direction;
}

double spring_length(const LeverModel& m, double angle) {
  const double a = angle + m.spring_angle;
  return std::hypot(m.pivot.x + m.spring_arm * std::cos(a) - m.anchor.x,
                    m.pivot.y + m.spring_arm * std::sin(a) - m.anchor.y);
}

// Elongation and force against the lever's angle, tabulated from rest to the end of the reach.
class LeverCurve {
 public:
  LeverCurve(const LeverModel& m, double stiffness_gain, double preload) {
    const double free = spring_length(m, m.rest) - preload, start = path_length(m, m.rest);
    const double stiffness = m.stiffness * (1.0 + stiffness_gain);
    // The lever gives way in the direction that shortens the path.
    const double h = 1.0e-6;
    const double sign = path_length(m, m.rest + h) < start ? 1.0 : -1.0;
    for (int i = 0; i < 1600; ++i) {
      const double angle = m.rest + sign * i * 1.0e-3;
      const double slope = (path_length(m, angle + h) - path_length(m, angle - h)) / (2.0 * h);
      const double stretch = spring_length(m, angle) - free;
      const double spring_slope =
          (spring_length(m, angle + h) - spring_length(m, angle - h)) / (2.0 * h);
      const double x = start - path_length(m, angle);
      if (!std::isfinite(x) || (i > 0 && x <= elongation_.back())) break;
      angle_.push_back(angle);
      elongation_.push_back(x);
      force_.push_back(-stiffness * stretch * spring_slope / slope);
      if (x > 1.6 * m.reach) break;
    }
  }
  double angle(double x) const { return read(elongation_, angle_, x); }
  double force(double x) const { return read(elongation_, force_, x); }
  double elongation_at(double angle) const {
    const double sign = angle_.back() > angle_.front() ? 1.0 : -1.0;
    const double step = 1.0e-3, at = sign * (angle - angle_.front()) / step;
    return between(elongation_, at);
  }
  double last_angle(double reach) const { return angle(reach); }

 private:
  static double between(const std::vector<double>& y, double at) {
    const double top = static_cast<double>(y.size()) - 1.001;
    at = std::clamp(at, 0.0, top);
    const auto i = static_cast<size_t>(at);
    const double s = at - static_cast<double>(i);
    return (1.0 - s) * y[i] + s * y[i + 1];
  }
  static double read(const std::vector<double>& x, const std::vector<double>& y, double at) {
    auto hit = std::upper_bound(x.begin() + 1, x.end() - 1, at);
    const auto i = static_cast<size_t>(hit - x.begin());
    const double s = (at - x[i - 1]) / (x[i] - x[i - 1]);
    return (1.0 - s) * y[i - 1] + s * y[i];
  }
  std::vector<double> angle_, elongation_, force_;
};

struct LeverHidden {
  double spring = 0.0, preload = 0.0, hysteresis = 0.0, series = 0.0, guiding = 0.0, slack = 0.0,
         force_offset = 0.0;
  double scale = 0.0, coarse = 0.0, creep = 0.0, wobble = 0.0;
};

struct LeverCause {
  Cause cause;
  double LeverHidden::*field;
};

// Which sample of a course is drawn at each row: some operators stop on their way every few
// seconds.
std::vector<size_t> stops(bool any, size_t rows, double period, Draw draw) {
  std::vector<size_t> at(rows, 0);
  const auto samples = [&](double low, double high) {
    return static_cast<size_t>(draw.uniform(low, high) / period);
  };
  size_t stop = samples(1.0, 3.0), left = 0;
  for (size_t k = 1; k < rows; ++k) {
    at[k] = at[k - 1] + (left == 0 ? 1 : 0);
    if (left > 0) --left;
    if (!any || at[k] != stop || left > 0) continue;
    left = samples(0.3, 1.2);
    stop += samples(1.0, 3.0);
  }
  return at;
}

class LeverPlant : public Plant {
 public:
  explicit LeverPlant(Draw draw) {
    model_.stiffness *= draw.log_uniform(0.7, 1.4);
    model_.arm *= draw.uniform(0.95, 1.05);
    guided_ = draw.chance(0.5);
    sigma_force_ = draw.uniform(0.3, 0.8);
    sigma_length_ = draw.uniform(1.5e-5, 4.0e-5);
    hysteresis_way_ = draw.uniform(2.0e-4, 6.0e-4);
    creep_time_ = draw.uniform(1.0, 4.0);
    wobble_rate_ = 2.0 * pi / draw.uniform(0.8e-3, 2.0e-3);
    for (auto& s : streams_) s = draw.bits();
    rests_ = draw.chance(0.5);
    guide_way_ = draw.uniform(2.0e-5, 8.0e-5);
    const LeverCurve curve(model_, 0.0, 0.0);
    first_angle_ = model_.rest;
    last_angle_ = curve.last_angle(1.15 * model_.reach);
    using H = LeverHidden;
    causes_ = {
        {{"spring_constant", "lever", "1", 0.02, 0.5, -0.4, false, false}, &H::spring},
        {{"preload_offset", "lever", "m", 5.0e-5, 3.0e-3, 0.0, false, false}, &H::preload},
        {{"lever_hysteresis", "lever", "N", 1.0, 30.0, 0.0, false, false}, &H::hysteresis},
        {{"series_tendon", "tendon", "m/N", 1.0e-6, 1.0e-4, 0.0, false, false}, &H::series},
        {{"slack", "tendon", "m", 5.0e-5, 3.0e-3, 0.0, false, false}, &H::slack},
        {{"sensor_scale", "sensor", "1", 0.01, 0.3, -0.3, false, false}, &H::scale},
        {{"sensor_quantisation", "sensor", "1", 20.0, 400.0, 0.0, false, false}, &H::coarse},
        {{"force_offset", "sensor", "N", 0.1, 30.0, -30.0, false, false}, &H::force_offset},
        {{"creep", "lever", "N", 1.0, 30.0, 0.0, true, false}, &H::creep},
        {{"wobble", "lever", "N", 1.0, 30.0, 0.0, true, false}, &H::wobble},
    };
    if (guided_)
      causes_.push_back(
          {{"guiding_friction", "tendon", "1", 0.02, 0.4, 0.0, false, false}, &H::guiding});
    for (const LeverCause& c : causes_) listed_.push_back(c.cause);
  }

  std::string kind() const override { return "lever"; }
  std::string nominal() const override {
    return fmt::format(
        "{{\"spring\": {:.17g}, \"arm\": {:.17g}, \"rest\": {:.17g}, "
        "\"count_first\": {:.17g}, \"count_last\": {:.17g}, \"bend\": {}}}",
        model_.stiffness, model_.arm, model_.rest, first_angle_, last_angle_, guided_);
  }
  const std::vector<Cause>& causes() const override { return listed_; }

  Table simulate(const std::vector<Dose>& doses, int log) const override {
    LeverHidden h;
    for (const Dose& d : doses) h.*causes_[static_cast<size_t>(d.cause)].field = d.value;
    const LeverCurve curve(model_, h.spring, h.preload);
    const size_t rows = 15000;
    const double period = 2.0e-3;
    Draw draw(streams_[static_cast<size_t>(log) % std::size(streams_)]);
    Motion motion(Course::mixed, 0.5 * model_.reach, 1.2 * model_.reach, 30.0, draw.fork());
    const std::vector<Reference> course = motion.table(period, rows);
    Table t;
    t.header = {"time [s]", "count [1]", "force [N]", "elongation [m]"};
    if (guided_) t.header.push_back("bend [rad]");
    t.columns.assign(t.header.size(), std::vector<double>(rows));
    const std::vector<size_t> at =
        stops(rests_, rows, period, Draw(~streams_[0] + static_cast<std::uint64_t>(log)));
    double grip = 0.0, held = 0.0, slow = 0.0, bend = 0.6, before = 0.5 * model_.reach,
           lever_before = 0.5 * model_.reach;
    for (size_t k = 0; k < rows; ++k) {
      const double drawn = std::clamp(0.52 * model_.reach + course[at[k]].position,
                                      0.02 * model_.reach, 1.1 * model_.reach);
      if (k % 3000 == 0) bend = draw.uniform(0.3, 3.0);
      // Drawn length = slack + lever + stretch of the tendon itself; three rounds settle it.
      double lever = lever_before, force = 0.0;
      for (int i = 0; i < 4; ++i) {
        force = std::max(0.0, curve.force(lever));
        lever = std::max(0.0, drawn - h.slack - h.series * force);
      }
      const double way = k > 0 ? lever - lever_before : 0.0;
      lever_before = lever;
      const double sign = way < 0.0 ? -1.0 : 1.0;
      const double part = std::abs(way) / hysteresis_way_;
      const double hold = sign * grip > 0.0 ? grip * grip : 0.0;
      grip = std::clamp(grip + sign * part * (1.0 - hold) / (1.0 + part), -1.0, 1.0);
      double seen = force + h.hysteresis * grip * std::min(1.0, force / 70.0);
      slow += period / creep_time_ * (force / 50.0 - slow);
      seen += h.creep * (force / 50.0 - slow) + h.wobble * std::sin(wobble_rate_ * lever);
      // The cell lies behind the bend: friction against the tendon's motion, kept where it stops.
      const double drawn_way = k > 0 ? drawn - before : 0.0;
      held = std::clamp(
          held + drawn_way / guide_way_ * (1.0 - std::abs(held) * (held * drawn_way > 0.0)), -1.0,
          1.0);
      if (guided_) seen *= std::exp(h.guiding * bend * held);
      before = drawn;
      seen += h.force_offset;
      const double share = (curve.angle(lever) - first_angle_) / (last_angle_ - first_angle_);
      double count = 4000.0 * share * (1.0 + h.scale) + 40.0;
      if (h.coarse > 0.0) count = h.coarse * std::round(count / h.coarse);
      t.columns[0][k] = static_cast<double>(k) * period;
      t.columns[1][k] = count;
      t.columns[2][k] = seen;
      t.columns[3][k] = drawn;
      if (guided_) t.columns[4][k] = bend;
    }
    return t;
  }

  std::vector<std::vector<double>> left_over(const Table& log,
                                             const std::vector<Dose>&) const override {
    const LeverCurve curve(model_, 0.0, 0.0);
    std::vector<std::vector<double>> left(2);
    for (size_t k = 0; k < log.columns[0].size(); k += 3) {
      const double share = (log.columns[1][k] - 40.0) / 4000.0;
      const double x = curve.elongation_at(first_angle_ + share * (last_angle_ - first_angle_));
      left[0].push_back((log.columns[2][k] - std::max(0.0, curve.force(x))) / sigma_force_);
      left[1].push_back((log.columns[3][k] - x) / sigma_length_);
    }
    return left;
  }

  void scale_noise(double factor) override {
    sigma_force_ *= factor;
    sigma_length_ *= factor;
  }

  void measure(Table& log, int number) const override {
    Draw draw(streams_[static_cast<size_t>(number) % std::size(streams_)] ^ 0x5bd1e995u);
    Noise force(draw.fork()), length(draw.fork());
    for (size_t k = 0; k < log.columns[0].size(); ++k) {
      log.columns[1][k] = std::round(log.columns[1][k]);
      log.columns[2][k] += sigma_force_ * force.next();
      log.columns[3][k] += sigma_length_ * length.next();
    }
  }

 private:
  LeverModel model_;
  bool guided_ = false, rests_ = false;
  double guide_way_ = 4.0e-5;
  double sigma_force_ = 0.5, sigma_length_ = 2.0e-5, hysteresis_way_ = 4.0e-4, creep_time_ = 2.0;
  double wobble_rate_ = 1.0, first_angle_ = 0.0, last_angle_ = 1.0;
  std::uint64_t streams_[4] = {};
  std::vector<LeverCause> causes_;
  std::vector<Cause> listed_;
};

}  // namespace

std::unique_ptr<Plant> draw_lever(Draw draw) {
  return std::make_unique<LeverPlant>(draw);
}

}  // namespace sinew::truth

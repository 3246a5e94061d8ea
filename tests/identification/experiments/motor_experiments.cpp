// SPDX-License-Identifier: GPL-3.0-or-later
// Chapter 3's experiments on logs of a motor whose parameters are known.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/experiments/compensation_effect.h"
#include "identification/experiments/friction_curve.h"
#include "identification/experiments/inertia_impulse.h"
#include "identification/experiments/ripple_fit.h"

using namespace sinew;

namespace {

constexpr double pi = 3.141592653589793;

/// models/motor's values.
MotorParameters motor() {
  MotorParameters p;
  p.gear_ratio = 0.01;
  p.rotor_inertia = 2e-7;
  p.gearbox_inertia = 5e-5;
  p.torque_constant = 0.0085;
  p.pulley_radius = 0.005;
  p.gamma1 = 10.0;
  p.gamma2 = 0.5586;
  p.gamma3 = 0.0356;
  p.output_ripple = {{1.0, 0.02, 0.3}};
  p.input_ripple = {{1.0, 0.04, 1.1}};
  return p;
}

/// A log of torque over time: from the motion, by chapter 3's equation written out here.
struct Simulated {
  double period = 1e-3;
  std::vector<double> theta, omega, torque;
  MotorParameters p = motor();
  double compensation = 0.0;  ///< share of the ripple fed forward

  double inertia() const {
    return p.rotor_inertia / (p.gear_ratio * p.gear_ratio) + p.gearbox_inertia;
  }
  double ripple(double angle) const {
    double sum = 0.0;
    for (const Ripple& r : p.output_ripple)
      sum += r.amplitude * std::sin(r.order * angle + r.phase);
    for (const Ripple& r : p.input_ripple)
      sum += r.amplitude * std::sin(r.order * angle / p.gear_ratio + r.phase);
    return sum;
  }
  double friction(double w) const { return p.gamma2 * std::atan(p.gamma1 * w) + p.gamma3 * w; }

  /// `command(t, theta, omega)` is the motor's torque; 20 midpoint steps a sample.
  template <typename Command>
  void run(double duration, Command command) {
    double angle = theta.empty() ? 0.0 : theta.back(), speed = omega.empty() ? 0.0 : omega.back();
    const double h = period / 20;
    const auto rate = [&](double t, double a, double w) {
      return (command(t, a, w) - friction(w) - (1.0 - compensation) * ripple(a)) / inertia();
    };
    for (long i = 0; i < std::lround(duration / period); ++i) {
      const double t = static_cast<double>(i) * period;
      theta.push_back(angle);
      omega.push_back(speed);
      torque.push_back(command(t, angle, speed));
      for (int k = 0; k < 20; ++k) {
        const double tk = t + k * h, a = rate(tk, angle, speed);
        const double middle = speed + h / 2 * a;
        angle += h * middle;
        speed += h * rate(tk + h / 2, angle - h / 2 * middle, middle);
      }
    }
  }
  void servo(double velocity, double duration) {
    const double start = theta.empty() ? 0.0 : theta.back();
    run(duration, [&, start](double t, double a, double w) {
      return 40.0 * (start + velocity * t - a) + (velocity - w) * 1.0;
    });
  }
  /// The same as a log: theta and tau_m; the velocity has to be taken from theta.
  Log log(const std::string& name, std::mt19937& random, double torque_noise,
          double theta_noise) const {
    const DriveStretch s = stretches(random, torque_noise, theta_noise).front();
    Log made;
    made.file = name;
    made.period = period;
    made.channels = {{"theta", "rad"}, {"tau_m", "N*m"}};
    Segment segment;
    segment.samples.resize(s.theta.size(), 2);
    segment.samples.col(0) = s.theta;
    segment.samples.col(1) = s.torque;
    made.segments.push_back(segment);
    return made;
  }
  std::vector<DriveStretch> stretches(std::mt19937& random, double torque_noise,
                                      double theta_noise) const {
    std::normal_distribution<double> unit;
    DriveStretch s;
    s.period = period;
    const auto n = static_cast<Eigen::Index>(theta.size());
    s.theta.resize(n);
    s.omega.resize(n);
    s.torque.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      s.theta(i) = theta[k] + theta_noise * unit(random);
      s.omega(i) = omega[k];
      s.torque(i) = torque[k] + torque_noise * unit(random);
    }
    return {s};
  }
};

Simulated constant_velocities() {
  Simulated log;
  for (const double v : {0.05, 0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.0})
    for (const double sign : {1.0, -1.0}) log.servo(sign * v, v < 0.15 ? 3.0 : 1.2);
  return log;
}

Simulated impulses() {
  Simulated log;
  for (int k = 0; k < 6; ++k)
    log.run(0.5, [k](double t, double, double) {
      return t < 0.08 ? (k % 2 ? -2.5 : 2.5) * std::sin(pi * t / 0.08) : 0.0;
    });
  return log;
}

constexpr int trials = 400;
void check_coverage(int covered) {
  CHECK(covered >= 0.92 * trials);
  CHECK(covered <= 0.98 * trials);
}

}  // namespace

TEST_CASE("friction's intervals cover the truth in 95 % of the trials", "[identify][slow]") {
  const Simulated log = constant_velocities();
  std::mt19937 random(1);
  int covered[3] = {};
  for (int trial = 0; trial < trials; ++trial) {
    const FrictionCurve curve = identify_friction(log.stretches(random, 0.02, 1e-6), 0.01);
    REQUIRE(curve.identified);
    covered[0] += curve.gamma1.covers(10.0);
    covered[1] += curve.gamma2.covers(0.5586);
    covered[2] += curve.gamma3.covers(0.0356);
  }
  for (const int each : covered) check_coverage(each);
}

TEST_CASE("the share of friction that may be fed forward leaves the motor passive", "[identify]") {
  const Simulated log = constant_velocities();
  std::mt19937 random(6);
  const FrictionCurve clean = identify_friction(log.stretches(random, 0.002, 1e-6), 0.01),
                      noisy = identify_friction(log.stretches(random, 0.2, 1e-6), 0.01);
  CHECK(clean.passive_share > 0.97);
  CHECK(clean.passive_share < 1.0);
  CHECK(noisy.passive_share < clean.passive_share);
  // Fed forward in full, an estimate gives energy in about half of the trials.
  int active = 0, safe = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const FrictionCurve c = identify_friction(log.stretches(random, 0.05, 1e-6), 0.01);
    bool whole = false, share = false;
    for (const double w : {0.01, 0.05, 0.2, 0.8, 3.0, 6.0}) {
      const double truth = friction_torque(10.0, 0.5586, 0.0356, w),
                   fitted = friction_torque(c.gamma1.value, c.gamma2.value, c.gamma3.value, w);
      whole = whole || fitted > truth;
      share = share || c.passive_share * fitted > truth;
    }
    active += whole;
    safe += !share;
  }
  CHECK(active > 50);
  CHECK(safe >= 95);
}

TEST_CASE("inertia is found, and without friction it is wrong", "[identify]") {
  const Simulated log = impulses();
  std::mt19937 random(2);
  int covered = 0;
  InertiaResult last;
  for (int trial = 0; trial < trials; ++trial) {
    last = identify_inertia(log.stretches(random, 0.02, 1e-6), motor());
    REQUIRE(last.identified);
    covered += last.inertia.covers(log.inertia());
  }
  check_coverage(covered);
  CAPTURE(last.inertia.value, last.without_friction.value, last.bias);
  CHECK(std::abs(last.bias) > 0.05);
  CHECK(!last.without_friction.covers(log.inertia()));
  CHECK(last.inertia.value == Approx(log.inertia()).epsilon(0.02));
}

TEST_CASE("inertia from an encoder's steps alone", "[identify]") {
  const Simulated pushed = impulses();
  std::mt19937 random(9);
  Log log = pushed.log("encoder", random, 0.02, 0.0);
  const double step = 2.0 * pi / 1048576.0;
  log.channels[0].quantum = step;
  for (double& each : log.segments[0].samples.col(0)) each = std::round(each / step) * step;
  const InertiaResult r = identify_inertia(drive_stretches(log), motor());
  CAPTURE(r.inertia.value, r.inertia.standard_error, r.missing);
  CHECK(r.identified);
  CHECK(std::abs(r.inertia.value - pushed.inertia()) < 4.0 * r.inertia.standard_error);
  CHECK(r.inertia.standard_error < 0.01 * pushed.inertia());
}

TEST_CASE("projected derivatives have the derivatives' values and signs", "[identify]") {
  const BumpProjection bumps(31, 1e-3);
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(31, 0.2, 0.23), one = Eigen::ArrayXd::Ones(31);
  const double weight = bumps.of(one, 0);
  CHECK(bumps.of(t, 0, 1) / weight == Approx(1.0).epsilon(1e-12));
  CHECK(bumps.of(3.0 * t * t, 0, 2) / weight == Approx(6.0).epsilon(1e-9));
  CHECK(bumps.of((40.0 * t).sin(), 0, 1) ==
        Approx(40.0 * bumps.of((40.0 * t).cos(), 0)).epsilon(1e-4));
  CHECK(bumps.of((40.0 * t).sin(), 0, 2) ==
        Approx(-1600.0 * bumps.of((40.0 * t).sin(), 0)).epsilon(1e-4));
}

TEST_CASE("without noise ripple and inertia are exact", "[identify]") {
  Simulated turning;
  for (const double v : {0.7, -0.5}) turning.servo(v, 10.0);
  std::mt19937 random(8);
  const RippleResult r = identify_ripple(turning.stretches(random, 0.0, 0.0), motor(), 2);
  REQUIRE(r.ripples.size() >= 2);
  CHECK(r.ripples[0].amplitude.value == Approx(0.04).epsilon(1e-4));
  CHECK(r.ripples[0].phase.value == Approx(1.1).epsilon(1e-4));
  CHECK(r.ripples[1].amplitude.value == Approx(0.02).epsilon(1e-4));
  CHECK(r.residual < 1e-5);
  // A friction that the model has wrong by a factor does not matter.
  MotorParameters weak = motor();
  weak.gamma2 *= 0.5;
  weak.gamma3 *= 0.5;
  const RippleResult same = identify_ripple(turning.stretches(random, 0.0, 0.0), weak, 2);
  CHECK(same.ripples[0].amplitude.value == Approx(0.04).epsilon(1e-4));
  const Simulated pushed = impulses();
  CHECK(identify_inertia(pushed.stretches(random, 0.0, 0.0), motor()).inertia.value ==
        Approx(pushed.inertia()).epsilon(1e-3));
}

TEST_CASE("ripple is found in the position domain", "[identify][slow]") {
  Simulated log;
  for (const double v : {0.7, -0.5}) log.servo(v, 10.0);
  std::mt19937 random(3);
  int covered[4] = {};
  for (int trial = 0; trial < trials; ++trial) {
    const RippleResult r = identify_ripple(log.stretches(random, 0.02, 1e-6), motor(), 2);
    REQUIRE(r.ripples.size() == 2);
    REQUIRE(r.ripples[0].order.input);
    REQUIRE(!r.ripples[1].order.input);
    covered[0] += r.ripples[0].amplitude.covers(0.04);
    covered[1] += r.ripples[0].phase.covers(1.1);
    covered[2] += r.ripples[1].amplitude.covers(0.02);
    covered[3] += r.ripples[1].phase.covers(0.3);
  }
  for (const int each : covered) check_coverage(each);
}

TEST_CASE("compensation shows at the motor's rotation frequency", "[identify]") {
  Simulated before, after;
  after.compensation = 0.9;
  for (Simulated* log : {&before, &after}) log->servo(0.7, 4.0);
  std::mt19937 random(4);
  const std::vector<Log> logs{before.log("before", random, 0.005, 1e-5),
                              after.log("after", random, 0.005, 1e-5)};
  const MotorOrderEffect effect = motor_order_effect(logs, 0.01, "omega");
  REQUIRE(effect.amplitudes.size() == 2);
  CHECK(effect.amplitudes[0].amplitude.value > 0.01);
  CHECK(effect.amplitudes[0].periods >= 40);
  REQUIRE(effect.reductions.size() == 1);
  CHECK(effect.reductions[0].log == "after");
  CHECK(effect.reductions[0].share_left.value == Approx(0.1).epsilon(0.2));
  CHECK(effect.reductions[0].share_left.standard_error < 0.02);
  CHECK(motor_order_effect(logs, 0.01, "tau_c").amplitudes.empty());
  // The same log twice: nothing is reduced.
  const auto same = motor_order_effect({logs[0], logs[0]}, 0.01, "omega").reductions;
  REQUIRE(same.size() == 1);
  CHECK(same[0].share_left.value == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("a log that cannot identify a parameter is told so", "[identify]") {
  std::mt19937 random(5);
  Simulated fast;
  for (const double v : {3.0, -3.0, 4.0, -4.0, 5.0, -5.0, 6.0, -6.0}) fast.servo(v, 1.0);
  const FrictionCurve curve = identify_friction(fast.stretches(random, 0.02, 1e-6), 0.01);
  CHECK(!curve.identified);
  REQUIRE(!curve.missing.empty());
  CHECK(curve.missing.front().find("gamma1 is not determined") == 0);
  CHECK(curve.missing.front().find("expected some where the friction still rises") !=
        std::string::npos);
  Simulated few;
  few.servo(1.0, 1.0);
  CHECK(identify_friction(few.stretches(random, 0.02, 1e-6), 0.01)
            .missing.front()
            .find("constant velocities over a whole motor turn") != std::string::npos);
  const InertiaResult steady = identify_inertia(few.stretches(random, 0.02, 1e-6), motor());
  CHECK(!steady.identified);
  REQUIRE(!steady.missing.empty());
  CHECK(steady.missing.front().find("expected torque impulses") != std::string::npos);
  Simulated still;
  still.run(2.0, [](double, double, double) { return 0.0; });
  CHECK(identify_ripple(still.stretches(random, 0.0, 0.0), motor())
            .missing.front()
            .find("expected constant velocities") != std::string::npos);
}

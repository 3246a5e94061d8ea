// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/diagnosis/synthetic_drive.h"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "identification/logs/filter.h"

namespace sinew::test {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Random = std::mt19937_64;
constexpr double kPi = std::numbers::pi;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Smooth moves between stops (cosine velocity profile) followed by a multi-sine.
VectorXd trajectory(Index n, double step, Random& random) {
  VectorXd q(n);
  const Index half = n / 2;
  double from = 0.0, to = uniform(random, 0.5, 1.5), start = 0.0;
  double length = uniform(random, 0.8, 2.5), rest = uniform(random, 0.0, 0.4);
  for (Index i = 0; i < half; ++i) {
    const double t = static_cast<double>(i) * step - start;
    if (t > length + rest) {
      start += length + rest;
      from = to;
      to = uniform(random, -1.5, 1.5);
      length = uniform(random, 0.8, 2.5);
      rest = uniform(random, 0.0, 0.4);
    }
    const double u = std::clamp((static_cast<double>(i) * step - start) / length, 0.0, 1.0);
    q(i) = from + (to - from) * (u - std::sin(2.0 * kPi * u) / (2.0 * kPi));
  }
  const double hold = q(half - 1);
  ArrayXd sines = ArrayXd::Zero(n - half);
  const ArrayXd t = ArrayXd::LinSpaced(n - half, 0.0, step * static_cast<double>(n - half - 1));
  for (const double f : {0.11, 0.23, 0.41, 0.77, 1.3}) {
    const double amplitude = uniform(random, 0.3, 1.0) * 0.25 / std::sqrt(f);
    const double rate = 2.0 * kPi * f * uniform(random, 0.9, 1.1);
    sines += amplitude * (rate * t + uniform(random, 0.0, 2.0 * kPi)).sin();
  }
  const ArrayXd blend = 0.5 - 0.5 * (kPi * (t / 1.0).min(1.0)).cos();
  q.tail(n - half) = hold * (1.0 - blend) + blend * sines;
  // No drive follows a jump in acceleration.
  return differentiate(q, step, 6.0).q;
}

/// LuGre friction of unit level on a given motion.
ArrayXd dynamic_friction(const VectorXd& q, double stiffness, int substeps) {
  ArrayXd force(q.size());
  double z = 0.0;
  for (Index i = 0; i < q.size(); ++i) {
    const double dq = i == 0 ? 0.0 : (q(i) - q(i - 1)) / substeps;
    // Implicit, hence stable for any stiffness.
    for (int k = 0; k < substeps; ++k) z = (z + dq) / (1.0 + std::abs(dq) * stiffness);
    force(i) = stiffness * z;
  }
  return force;
}

/// Low-passed noise plus a white part, unit rms.
VectorXd coloured_noise(Index n, double step, Random& random) {
  std::normal_distribution<double> gauss;
  const double pole = std::exp(-2.0 * kPi * uniform(random, 0.3, 15.0) * step);
  const double second = std::exp(-2.0 * kPi * uniform(random, 5.0, 60.0) * step);
  const double white = uniform(random, 0.02, 0.5);
  VectorXd x(n);
  double a = 0.0, b = 0.0;
  for (Index i = -4000; i < n; ++i) {
    a = pole * a + gauss(random);
    b = second * b + a;
    if (i >= 0) x(i) = b;
  }
  x *= std::sqrt(static_cast<double>(n)) / x.norm();
  for (Index i = 0; i < n; ++i) x(i) += white * gauss(random);
  return x * (std::sqrt(static_cast<double>(n)) / x.norm());
}

/// The motion as the effects see it.
struct Truth {
  ArrayXd t, q, v, a, friction, load, model;
  double period_in, period_out, step;
};

ArrayXd time_shifted(const ArrayXd& x, double samples) {
  ArrayXd y(x.size());
  for (Index i = 0; i < x.size(); ++i) {
    const double at =
        std::clamp(static_cast<double>(i) + samples, 0.0, static_cast<double>(x.size() - 1) - 1e-9);
    const auto k = static_cast<Index>(at);
    const double f = at - static_cast<double>(k);
    y(i) = x(k) * (1.0 - f) + x(k + 1) * f;
  }
  return y;
}

ArrayXd play(const Truth& s, double gap) {
  ArrayXd out(s.q.size());
  double follower = s.q(0);
  for (Index i = 0; i < s.q.size(); ++i) {
    if (s.q(i) - follower > gap / 2) follower = s.q(i) - gap / 2;
    if (follower - s.q(i) > gap / 2) follower = s.q(i) + gap / 2;
    const bool inside = std::abs(s.q(i) - follower) < gap / 2 * (1.0 - 1e-9);
    out(i) = inside ? -s.a(i) : 0.0;
  }
  return out;
}

ArrayXd effect(const std::string& name, const Truth& s, Random& random) {
  const double vmax = s.v.abs().maxCoeff();
  const double phase = uniform(random, 0.0, 2.0 * kPi), sign = uniform(random, -1, 1) > 0 ? 1 : -1;
  const auto ripple = [&](double order, double period) -> ArrayXd {
    return (2.0 * kPi * order / period * s.q + phase).sin();
  };
  if (name == "viscous asymmetry") return sign * s.v.max(0.0);
  if (name == "Stribeck friction")
    return s.friction * (-s.v.abs() / (uniform(random, 0.03, 0.15) * vmax)).exp();
  if (name == "friction concave in speed")
    return s.friction * (s.v.abs() / vmax).pow(uniform(random, 0.3, 0.6));
  if (name == "quadratic friction") return s.v * s.v.abs();
  if (name == "drift of friction") return sign * s.friction * s.t;
  if (name == "friction varies with position") return sign * s.friction * s.q;
  if (name == "load-dependent friction") return s.friction * s.load;
  if (name.starts_with("ripple, input order ")) return ripple(name.back() - '0', s.period_in);
  if (name.starts_with("ripple, output order ")) return ripple(name.back() - '0', s.period_out);
  if (name == "ripple proportional to load, input order 1") return s.load * ripple(1, s.period_in);
  if (name == "gear elasticity") {
    ArrayXd d = ArrayXd::Zero(s.a.size());
    for (Index i = 2; i + 2 < d.size(); ++i) d(i) = s.a(i + 2) - 2.0 * s.a(i) + s.a(i - 2);
    return d;
  }
  if (name == "backlash") return play(s, uniform(random, 2e-3, 2e-2));
  if (name == "delay") return time_shifted(s.model, 1.0) - s.model;
  if (name == "spring") return s.q;
  if (name == "position-dependent cable torque")
    return (2.5 * s.q + phase).sin() + 0.5 * (5.0 * s.q + 2.0 * phase).sin();
  if (name == "offset drift") return sign * s.t;
  // Foreign ones.
  if (name == "vibration in time")
    return (2.0 * kPi * uniform(random, 4.0, 30.0) * s.t + phase).sin();
  if (name == "sticky spot")
    return s.friction * (-((s.q - uniform(random, -0.4, 0.4)) / 0.12).square()).exp();
  if (name == "odd ripple") return ripple(uniform(random, 1.55, 1.8), s.period_in);
  if (name == "bump in position")
    return (-((s.q - uniform(random, -0.4, 0.4)) / 0.08).square()).exp();
  if (name == "speed resonance")
    return (-((s.v.abs() - uniform(random, 0.35, 0.6) * vmax) / (0.08 * vmax)).square()).exp() *
           s.friction;
  if (name == "offset jump")
    return (s.t > uniform(random, 0.3, 0.7) * s.t(s.t.size() - 1)).cast<double>();
  throw std::invalid_argument("no effect called " + name);
}

}  // namespace

const std::vector<std::string>& hidden_effects() {
  static const std::vector<std::string> names{"viscous asymmetry",
                                              "Stribeck friction",
                                              "friction concave in speed",
                                              "quadratic friction",
                                              "drift of friction",
                                              "friction varies with position",
                                              "load-dependent friction",
                                              "ripple, input order 1",
                                              "ripple, input order 2",
                                              "ripple, input order 3",
                                              "ripple, output order 1",
                                              "ripple, output order 2",
                                              "ripple proportional to load, input order 1",
                                              "gear elasticity",
                                              "backlash",
                                              "delay",
                                              "spring",
                                              "position-dependent cable torque",
                                              "offset drift"};
  return names;
}

const std::vector<std::string>& foreign_effects() {
  static const std::vector<std::string> names{"vibration in time", "sticky spot",
                                              "odd ripple",        "bump in position",
                                              "speed resonance",   "offset jump"};
  return names;
}

SyntheticDrive simulate_drive(const std::vector<std::string>& effects,
                              const std::vector<double>& sizes, double duration, unsigned seed) {
  Random random(seed * 7919ULL + 13);
  constexpr double kStep = 2e-3;
  const auto n = static_cast<Index>(duration / kStep);
  Truth s;
  s.step = kStep;
  const VectorXd q = trajectory(n, kStep, random);
  const Motion exact = differentiate(q, kStep, 40.0);
  s.t = ArrayXd::LinSpaced(n, 0.0, kStep * static_cast<double>(n - 1));
  s.q = exact.q;
  s.v = exact.qd;
  s.a = exact.qdd;
  s.friction =
      dynamic_friction(exact.q, std::exp(uniform(random, std::log(5e2), std::log(2e4))), 40);
  s.load = 1.5 + (2.0 * kPi * uniform(random, 0.05, 0.3) * s.t + 1.0).sin();
  s.period_in = uniform(random, 0.15, 0.3);
  s.period_out = uniform(random, 1.2, 2.0);
  SyntheticDrive drive;
  // Drawn from the last to the first.
  drive.values(3) = 0.2;
  drive.values(2) = uniform(random, 1.0, 3.0);
  drive.values(1) = uniform(random, 0.5, 2.0);
  drive.values(0) = uniform(random, 0.5, 2.0);
  s.model = drive.values(0) * s.a + drive.values(1) * s.v + drive.values(2) * s.friction +
            drive.values(3);
  const double noise = 0.1 * std::sqrt(s.model.square().mean());
  MatrixXd base(n, 4);
  base << s.a.matrix(), s.v.matrix(), s.friction.matrix(), VectorXd::Ones(n);
  const Eigen::HouseholderQR<MatrixXd> qr(base);
  VectorXd force = s.model.matrix() + noise * coloured_noise(n, kStep, random);
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const VectorXd shape = effect(effects[i], s, random).matrix();
    const VectorXd apart = shape - base * qr.solve(shape);
    // The ends are cut off later: what is large there only must not set the scale.
    const Index edge = 200, inner = n - 2 * edge;
    force += shape * (sizes[i] * noise * std::sqrt(static_cast<double>(inner)) /
                      apart.segment(edge, inner).norm());
  }
  drive.parts = base * drive.values.asDiagonal();
  drive.noise = noise;
  drive.period_in = s.period_in;
  drive.period_out = s.period_out;
  drive.log.name = "synthetic";
  drive.log.step = kStep;
  drive.log.time = s.t;
  std::normal_distribution<double> gauss;
  VectorXd measured = q;
  for (Index i = 0; i < n; ++i) measured(i) += 1e-6 * gauss(random);
  const Motion motion = differentiate(measured, kStep, 60.0);
  drive.log.q = motion.q;
  drive.log.qd = motion.qd;
  drive.log.qdd = motion.qdd;
  drive.log.load = s.load.matrix();
  drive.log.target = {force};
  return drive;
}

}  // namespace sinew::test

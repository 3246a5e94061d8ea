// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/parts/lever.h"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/expressions/horner.h"
#include "tests/symbolic/parts/differences.h"
#include "tests/symbolic/parts/hand_parameters.h"

using namespace sinew;
using namespace sinew_tests;
using Eigen::Vector2d;

namespace {

Vector2d at_angle(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Tangent from one pulley to the next found numerically: the angles of both tangent points, from
/// the two conditions that the stretch is normal to both radii.
struct Tangent {
  Tangent(const Pulley& from, const Pulley& to, double from_angle, double to_angle)
      : out(from_angle), in(to_angle) {
    for (int i = 0; i < 50; ++i) {
      const Vector2d stretch = gap(from, to);
      const Vector2d r1 = at_angle(out), r2 = at_angle(in), d1(-r1.y(), r1.x()),
                     d2(-r2.y(), r2.x());
      Eigen::Matrix2d slope;
      slope << stretch.dot(d1), to.radius * d2.dot(r1), -from.radius * d1.dot(r2), stretch.dot(d2);
      const Vector2d step = slope.lu().solve(Vector2d(stretch.dot(r1), stretch.dot(r2)));
      out -= step.x();
      in -= step.y();
    }
    length = gap(from, to).norm();
  }
  Vector2d gap(const Pulley& from, const Pulley& to) const {
    return to.centre + to.radius * at_angle(in) - from.centre - from.radius * at_angle(out);
  }
  double out, in, length = 0;
};

/// Path from a mark on the motor pulley to a mark on the fixed pulley, by tangent points and arcs.
double numeric_path(const LeverParameters& p, double theta) {
  const Pulley lever{p.pivot + p.lever_length * at_angle(theta), p.pulley_radius, p.pulley_sense};
  // Tangent points lie to the right of the way for a counter-clockwise pulley, else to the left.
  const auto side = [](const Pulley& a, const Pulley& b, int sense) {
    const Vector2d d = b.centre - a.centre;
    return std::atan2(d.y(), d.x()) - sense * std::numbers::pi / 2;
  };
  const Tangent first(p.motor, lever, side(p.motor, lever, p.motor.sense),
                      side(p.motor, lever, lever.sense));
  const Tangent second(lever, p.fixed, side(lever, p.fixed, lever.sense),
                       side(lever, p.fixed, p.fixed.sense));
  return first.length + second.length + p.motor.sense * p.motor.radius * first.out +
         lever.sense * lever.radius * (second.out - first.in) -
         p.fixed.sense * p.fixed.radius * second.in;
}

double spring_energy(const LeverParameters& p, double theta) {
  const auto length = [&p](double at) {
    return (p.pivot + p.spring_arm * at_angle(at + p.spring_angle) - p.anchor).norm();
  };
  return 0.5 * p.spring_stiffness * std::pow(length(theta) - length(p.free_angle), 2);
}

}  // namespace

TEST_CASE("lever reproduces its force and stiffness curve", "[lever]") {
  const LeverParameters p = lever_parameters();
  const Function state = lever_state(p);
  const auto free = evaluate(state, {p.free_angle}), end = evaluate(state, {p.end_angle});
  CHECK(std::abs(free[1]) < 1e-17);
  CHECK(std::abs(free[2]) < 1e-12);
  CHECK(free[3] / 1000 == Approx(5.6).margin(0.05));
  CHECK(end[1] == Approx(0.010).epsilon(1e-12));
  CHECK(end[2] == Approx(99).margin(0.5));
  CHECK(end[3] / 1000 == Approx(41.8).margin(0.05));
  double last_force = -1, last_stiffness = 0;
  for (int i = 0; i <= 20; ++i) {
    const auto out = evaluate(state, {p.free_angle + (p.end_angle - p.free_angle) * i / 20});
    CHECK(out[2] > last_force);
    CHECK(out[3] > last_stiffness);
    last_force = out[2];
    last_stiffness = out[3];
  }
}

TEST_CASE("lever path equals tangents found numerically and their arcs", "[lever]") {
  const LeverParameters p = lever_parameters();
  const Function state = lever_state(p);
  const double difference_at_start =
      numeric_path(p, p.free_angle) - evaluate(state, {p.free_angle})[0];
  for (double theta = p.end_angle; theta < p.free_angle; theta += 0.05)
    CHECK(numeric_path(p, theta) - evaluate(state, {theta})[0] ==
          Approx(difference_at_start).epsilon(1e-14).margin(1e-16));
  // Without the arcs on the motor pulley and the fixed pulley, half of the 10 mm is missed.
  const auto without_arcs = [&p](double theta) {
    const Pulley lever{p.pivot + p.lever_length * at_angle(theta), p.pulley_radius, p.pulley_sense};
    const Vector2d d12 = lever.centre - p.motor.centre, d23 = p.fixed.centre - lever.centre;
    const double k12 = p.motor.radius + lever.radius, k23 = -lever.radius - p.fixed.radius;
    const double L12 = std::sqrt(d12.squaredNorm() - k12 * k12),
                 L23 = std::sqrt(d23.squaredNorm() - k23 * k23);
    const double phi12 = std::atan2(d12.y(), d12.x()) + std::atan2(k12, L12);
    const double phi23 = std::atan2(d23.y(), d23.x()) + std::atan2(k23, L23);
    return L12 + L23 + lever.sense * lever.radius * (phi23 - phi12);
  };
  CHECK(without_arcs(p.free_angle) - without_arcs(p.end_angle) == Approx(0.00506).margin(0.00001));
}

TEST_CASE("lever obeys virtual work and its derivative identities", "[lever]") {
  const LeverParameters p = lever_parameters();
  const Function state = lever_state(p), slope = lever_slope(p);
  for (double theta = p.end_angle; theta <= p.free_angle - 0.02; theta += 0.06) {
    const auto out = evaluate(state, {theta}), virtual_work = evaluate(slope, {theta}),
               by_theta = difference(state, {theta}, 0);
    CHECK(virtual_work[0] == Approx(by_theta[0]).epsilon(1e-12));  // dL' by differences
    CHECK(out[2] * virtual_work[0] == Approx(-virtual_work[1]).epsilon(1e-12));
    CHECK(by_theta[1] == Approx(-by_theta[0]).epsilon(1e-12));
    CHECK(out[3] == Approx(by_theta[2] / by_theta[1]).epsilon(1e-12));  // df/dx
    const double h = 1e-4;
    CHECK(virtual_work[1] ==
          Approx((spring_energy(p, theta + h) - spring_energy(p, theta - h)) / (2 * h))
              .epsilon(1e-6));
  }
}

TEST_CASE("lever angle inverts the elongation", "[lever]") {
  const LeverParameters p = lever_parameters();
  const Function angle = lever_angle(p), state = lever_state(p);
  for (int i = 0; i <= 20; ++i) {
    const double elongation = 0.010 * i / 20;
    for (const double start : {p.free_angle, p.end_angle, 0.4}) {
      const auto found = evaluate(angle, {elongation, start});
      CHECK(std::abs(found[1]) < 1e-15);
      CHECK(evaluate(state, {found[0]})[1] == Approx(elongation).margin(1e-15));
    }
  }
  // Beyond the travel the angle stays at its end and the residual tells.
  const auto beyond = evaluate(angle, {0.015, p.free_angle}), slack = evaluate(angle, {-0.01, 0.2});
  CHECK(beyond[0] == Approx(p.end_angle).epsilon(1e-15));
  CHECK(std::abs(beyond[1]) > 1e-3);
  CHECK(slack[0] == Approx(p.free_angle).epsilon(1e-15));
  CHECK(all_finite(evaluate(angle, {1e9, -1e9})));
  CHECK_THROWS_AS(lever_angle_at(p, 0.05), std::domain_error);
}

TEST_CASE("lever status and finite values anywhere", "[lever]") {
  const LeverParameters p = lever_parameters();
  const Function status = lever_status(p), state = lever_state(p);
  CHECK(evaluate(status, {p.free_angle})[0] == 0.0);
  CHECK(evaluate(status, {p.end_angle})[0] == 0.0);
  CHECK(evaluate(status, {0.4})[0] == 0.0);
  CHECK(evaluate(status, {p.free_angle + 0.01})[0] == 1.0);
  CHECK(evaluate(status, {p.end_angle - 0.01})[0] == 1.0);
  for (double theta = -7; theta < 7; theta += 0.05) CHECK(all_finite(evaluate(state, {theta})));
}

TEST_CASE("calibrated stiffness is the force's derivative along the length", "[lever]") {
  const LeverCalibration calibration{2000, 1500, {30, 40, 12, 3.5}, {0.05, -0.005, 0.0004}, 1e-6};
  const Function state = lever_calibrated_state(calibration);
  for (const double counts : {500.0, 1333.0, 2000.0, 3400.0}) {
    const double u = (counts - 2000) / 1500;
    const auto out = evaluate(state, {counts});
    CHECK(out[0] == Approx(0.05 - 0.005 * u + 0.0004 * u * u).epsilon(1e-15));
    CHECK(out[1] == Approx(30 + 40 * u + 12 * u * u + 3.5 * u * u * u).epsilon(1e-14));
    if (counts == 500.0) continue;  // the limit: no derivative to compare with
    const auto slope = difference(state, {counts}, 0);
    CHECK(out[2] == Approx(-slope[1] / slope[0]).epsilon(1e-12));
  }
  CHECK(evaluate(state, {-1e6})[1] == evaluate(state, {500.0})[1]);
}

TEST_CASE("Horner form takes one definition a step", "[horner]") {
  DefinitionList list;
  const GiNaC::symbol x("x");
  const GiNaC::ex value = horner(list, "p", {1, -2, 0.5, 3}, x);
  CHECK(list.items().size() == 3);
  Function function{
      "p", "", "", {{"x", 1, 1, {x}, "", "", {}}}, list.items(), {{"y", 1, 1, {value}, "", ""}}};
  CHECK(evaluate(function, {2.0})[0] == 1 - 4 + 2 + 24);
  CHECK(derived_coefficients({1, -2, 0.5, 3}) == std::vector<double>{-2, 1, 9});
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The lever's calibration from counts, with noise and a hysteresis loop.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/experiments/lever_calibration.h"
#include "identification/experiments/lever_loop.h"
#include "symbolic/expressions/evaluate_function.h"

using namespace sinew;

namespace {

/// A stiffening spring: force and elongation over the sensor's range s in [0, 1].
double force_at(double s) {
  return 90.0 * (std::exp(1.5 * s) - 1.0) / (std::exp(1.5) - 1.0);
}
double elongation_at(double s) {
  return 0.010 * (0.8 * s + 0.2 * std::sin(1.5 * s));
}
double stiffness_at(double s) {
  const double step = 1e-6;
  return (force_at(s + step) - force_at(s - step)) /
         (elongation_at(s + step) - elongation_at(s - step));
}

/// Slow pulls and releases; the loop is `hysteresis` wide in its middle.
Log pulled(double hysteresis, double noise, bool with_elongation, bool release = true) {
  Log log;
  log.period = 0.01;
  const long n = 6000;
  Channel count{"count", "1"}, force{"force", "N"}, elongation{"elongation", "m"};
  log.channels = {count, force};
  if (with_elongation) log.channels.push_back(elongation);
  Segment segment;
  segment.samples.resize(n, with_elongation ? 3 : 2);
  std::mt19937 random(1);
  std::normal_distribution<double> unit;
  for (long i = 0; i < n; ++i) {
    const double t = 3.0 * static_cast<double>(i) / static_cast<double>(n),
                 phase = t - std::floor(t);
    const bool up = !release || phase < 0.5;
    const double s = !release ? t / 3.0 : up ? 2.0 * phase : 2.0 - 2.0 * phase;
    segment.samples(i, 0) = std::round(300.0 + 3500.0 * s);
    segment.samples(i, 1) =
        force_at(s) + noise * unit(random) + (up ? 0.5 : -0.5) * hysteresis * 4.0 * s * (1.0 - s);
    if (with_elongation) segment.samples(i, 2) = elongation_at(s) + 2e-6 * unit(random);
  }
  log.segments.push_back(segment);
  return log;
}

}  // namespace

TEST_CASE("the lever's sensor is calibrated and its loop measured", "[identify]") {
  const LeverCalibrationResult r = calibrate_lever({pulled(15.0, 0.1, true)});
  REQUIRE(r.identified);
  CHECK(r.missing.empty());
  CHECK(r.hysteresis == Approx(15.0).epsilon(0.05));
  CHECK(r.force.degree() >= 3);
  CHECK(r.largest_force_error < 9.0);
  CHECK(r.largest_length_error < 2e-5);
  const Function emitted = lever_calibrated_state(r.calibration);
  double worst = 0.0;
  for (double s = 0.1; s < 0.95; s += 0.1) {
    const std::vector<double> state = evaluate(emitted, {300.0 + 3500.0 * s});
    CHECK(state[0] == Approx(-elongation_at(s)).margin(5e-6));
    CHECK(state[1] == Approx(force_at(s)).margin(0.5));
    worst = std::max(worst, std::abs(state[2] / stiffness_at(s) - 1.0));
  }
  CHECK(worst < 0.05);
}

TEST_CASE("a loop's state turns over its length and does not follow the sensor's steps",
          "[identify]") {
  Eigen::ArrayXd u(401);
  for (Eigen::Index i = 0; i < 401; ++i)
    u(i) = i <= 200 ? 0.005 * static_cast<double>(i) : 2.0 - 0.005 * static_cast<double>(i);
  const Eigen::ArrayXd z = loop_state(u, {0}, 1e-6, 0.1);
  CHECK(z(0) == 0.0);
  CHECK(z(200) == Approx(1.0).margin(1e-4));
  // 0.1 further the distance to the other side has fallen to 1/e.
  CHECK(z(220) == Approx(2.0 * std::exp(-1.0) - 1.0).margin(1e-3));
  CHECK(z(400) == Approx(-1.0).margin(1e-3));
  Eigen::ArrayXd still = u;
  for (Eigen::Index i = 0; i < 401; ++i) still(i) = 0.5 + (i % 2 ? 0.001 : 0.0);
  CHECK(loop_state(still, {0}, 0.0015, 0.1).abs().maxCoeff() == 0.0);
}

TEST_CASE("the degree is the force's, whatever the loop does where it turns", "[identify]") {
  // A cubic force in a loop that turns over a twentieth of the travel.
  const Eigen::Index n = 4000;
  Eigen::ArrayXd u(n), force(n);
  for (Eigen::Index i = 0; i < n; ++i)
    u(i) = -std::cos(4.0 * 3.14159265 * static_cast<double>(i) / static_cast<double>(n));
  const Eigen::ArrayXd z = loop_state(u, {0}, 0.0, 0.1);
  std::mt19937 random(3);
  std::normal_distribution<double> unit;
  for (Eigen::Index i = 0; i < n; ++i)
    force(i) = 40.0 + 35.0 * u(i) + 10.0 * std::pow(u(i), 3) + 6.0 * z(i) + 0.1 * unit(random);
  const MiddleOfLoop middle = middle_of_loop(u, force, {0}, 0.0, 9);
  CHECK(middle.length == Approx(0.1).epsilon(0.1));
  const CalibrationPolynomial p = fit_polynomial(u, middle.force, 9);
  CHECK(p.degree() <= 5);
  for (const double at : {-0.9, 0.0, 0.9})
    CHECK(p.at(at) == Approx(40.0 + 35.0 * at + 10.0 * std::pow(at, 3)).margin(0.3));
}

TEST_CASE("without a loop none is reported, and the stiffness agrees with the force",
          "[identify]") {
  const LeverCalibrationResult r = calibrate_lever({pulled(0.0, 0.05, true)});
  CHECK(r.hysteresis < 0.5);
  CHECK(r.stiffness_mismatch < 0.05);
}

TEST_CASE("the degree follows the data, not the highest allowed", "[identify]") {
  std::mt19937 random(2);
  std::normal_distribution<double> unit;
  Eigen::ArrayXd u = Eigen::ArrayXd::LinSpaced(400, -1, 1), v(400);
  for (Eigen::Index i = 0; i < 400; ++i)
    v(i) = 1.0 + u(i) - 2.0 * u(i) * u(i) * u(i) + 0.01 * unit(random);
  const CalibrationPolynomial p = fit_polynomial(u, v, 9);
  CHECK(p.degree() == 3);
  CHECK(p.coefficients[3] == Approx(-2.0).epsilon(0.01));
  CHECK(p.slope(0.5) == Approx(1.0 - 6.0 * 0.25).epsilon(0.02));
}

TEST_CASE("a calibration log that says too little is told so", "[identify]") {
  const LeverCalibrationResult without = calibrate_lever({pulled(15.0, 0.1, false)});
  CHECK(!without.identified);
  CHECK(without.missing.front().find("there is no elongation") == 0);
  const LeverCalibrationResult one_way = calibrate_lever({pulled(15.0, 0.1, true, false)});
  CHECK(!one_way.identified);
  REQUIRE(!one_way.missing.empty());
  CHECK(one_way.missing.front().find("hysteresis is not seen") != std::string::npos);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a sensor, and the motion behind them.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "identification/logs/dequantise.h"
#include "identification/logs/sensor_steps.h"

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double step = 0.001;  // s

double rounded(double x, double unit) {
  return unit * std::round(x / unit);
}

/// A motion that passes several steps a sample and goes to and fro five times a second.
VectorXd motion_of(Index samples) {
  VectorXd motion(samples);
  for (Index k = 0; k < samples; ++k) {
    const double t = step * static_cast<double>(k);
    motion(k) = 0.03 * std::sin(30.0 * t) + 0.2 * std::sin(1.7 * t + 0.3);
  }
  return motion;
}

}  // namespace

TEST_CASE("a coarse sensor's step is found behind a finer grid") {
  const double coarse = 2.0489e-4, fine = 9.48e-6;
  const auto rounded = [](double x, double unit) { return unit * std::round(x / unit); };
  VectorXd motion(8000), twice(8000), once(8000), held(8000);
  for (Index k = 0; k < motion.size(); ++k) {
    motion(k) = 0.4 * std::sin(5.0 * step * static_cast<double>(k));
    twice(k) = rounded(rounded(motion(k), coarse), fine);
    once(k) = rounded(motion(k), fine);
    held(k) = rounded(rounded(motion(k), 100.0 * coarse), fine);
  }
  CHECK(sensor_steps(twice).step == Catch::Detail::Approx(coarse).epsilon(1e-3));
  CHECK(sensor_steps(once).step == Catch::Detail::Approx(fine).epsilon(1e-3));
  CHECK(sensor_steps(twice).scatter == Catch::Detail::Approx(fine / std::sqrt(12.0)).epsilon(0.1));
  CHECK(sensor_steps(once).scatter < 1e-3 * fine);
  // Seen to fail where changes must vary: a step at a time is all that a very coarse sensor shows.
  CHECK(sensor_steps(held).step == Catch::Detail::Approx(100.0 * coarse).epsilon(1e-3));
  // Planted: no steps, and strokes at constant speeds in whole ratios, whose changes from sample to
  // sample are multiples of one.
  CHECK(sensor_steps(motion).step == 0.0);
  for (const double most : {1.0, 3.0}) {
    VectorXd strokes = VectorXd::Zero(8000);
    double speed = 0.0, place = 0.0;
    for (Index k = 0; k < strokes.size(); ++k) {
      const auto stroke = static_cast<double>(k / 500);
      const double wanted = (std::fmod(stroke, most) + 1.0) * (k / 500 % 2 == 0 ? 0.1 : -0.1);
      speed += 0.1 * (wanted - speed);
      place += step * speed;
      strokes(k) = place;
    }
    CHECK(sensor_steps(strokes).step == 0.0);
  }
  VectorXd uniform = VectorXd::LinSpaced(8000, 0.0, 0.8);
  CHECK(sensor_steps(uniform).step == 0.0);
}

TEST_CASE("a sensor's steps are found beside the noise of its reading") {
  // Planted: with changes that must be equal to be a step's, none of these is found.
  std::mt19937 draw(7);
  std::normal_distribution<double> normal;
  const VectorXd motion = motion_of(9000);
  for (const double coarse : {2e-4, 1e-3, 1e-2})
    for (const double noise : {0.02, 0.1, 0.15}) {
      INFO(coarse << " with noise of " << noise << " steps");
      VectorXd reading(motion.size()), smooth(motion.size());
      for (Index k = 0; k < motion.size(); ++k) {
        const double error = noise * coarse * normal(draw);
        reading(k) = rounded(motion(k), coarse) + error;
        smooth(k) = motion(k) + error;
      }
      const SensorSteps steps = sensor_steps(reading);
      CHECK(steps.step == Approx(coarse).epsilon(1e-3));
      CHECK(std::abs(std::remainder(steps.offset, coarse)) < 0.02 * coarse);
      CHECK(steps.scatter == Approx(noise * coarse).epsilon(0.05));
      CHECK(sensor_steps(smooth).step == 0.0);
    }
}

TEST_CASE("the motion behind a sensor's steps is told to less than half of their error") {
  // Planted: without the bounds that the readings set 0.54 of the finest sensor's error is left,
  // and without the lines between changes 0.80 of the slow motion's.
  const VectorXd fast = motion_of(9000);
  VectorXd slow(20000);
  for (Index k = 0; k < slow.size(); ++k) slow(k) = 0.03 * std::sin(step * static_cast<double>(k));
  const auto left = [](const VectorXd& motion, double coarse) {
    VectorXd reading(motion.size());
    for (Index k = 0; k < motion.size(); ++k) reading(k) = rounded(motion(k), coarse);
    const VectorXd found = consistent_motion(reading, sensor_steps(reading), step, 30.0);
    return (found - motion).norm() / (reading - motion).norm();
  };
  for (const double coarse : {2e-4, 1e-3, 1e-2}) CHECK(left(fast, coarse) < 0.5);
  CHECK(left(slow, 1e-3) < 0.5);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/expected_motion.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "identification/logs/filter.h"

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using namespace sinew::diagnosis;

namespace {

constexpr double kStep = 0.002, kCutoff = 50.0;
constexpr double kQuiet = 2.0 * kCutoff;
constexpr Index kRows = 5000;

/// Motion of all frequencies up to 90 Hz, the faster the less.
VectorXd moved() {
  VectorXd q = VectorXd::Zero(kRows);
  for (int line = 1; line <= 180; ++line) {
    const double omega = std::numbers::pi * line;
    for (Index k = 0; k < kRows; ++k)
      q(k) += std::sin(omega * kStep * static_cast<double>(k) + 0.7 * line * line) /
              (std::pow(omega, 2.0) * (1.0 + std::pow(omega / 80.0, 3.0)));
  }
  return q;
}

VectorXd read(const VectorXd& q, double noise) {
  std::mt19937 draw(5);
  std::normal_distribution<double> normal(0.0, noise);
  return q.unaryExpr([&](double x) { return x + normal(draw); });
}

/// Share by which a mass of 1 is fitted too small: its effort by the true motion less what the
/// model asks for, against the acceleration that is seen.
double missing_mass(const VectorXd& q, const MatrixXd& seen) {
  const Index edge = 200;
  const VectorXd effort = differentiate(q, kStep, kCutoff).qdd.col(0);
  const VectorXd a = differentiate(seen, kStep, kCutoff).qdd.col(0);
  const VectorXd x = a.segment(edge, kRows - 2 * edge);
  const VectorXd left = effort.segment(edge, kRows - 2 * edge) - x;
  return -left.dot(x) / x.squaredNorm();
}

}  // namespace

TEST_CASE("a mass fitted to the expected motion is no smaller for the sensor's noise") {
  const VectorXd q = moved(), reading = read(q, 3e-5);
  // As it was read: what all regressors were made of before.
  CHECK(missing_mass(q, reading) > 0.03);
  CHECK(std::abs(missing_mass(q, expected_position(reading, kStep, kQuiet))) < 0.005);
}

TEST_CASE("a reading without noise is the motion itself") {
  const VectorXd q = moved();
  const MatrixXd expected = expected_position(q, kStep, kQuiet);
  CHECK((expected.col(0) - q).cwiseAbs().maxCoeff() < 1e-5 * q.cwiseAbs().maxCoeff());
  const VectorXd still = VectorXd::Constant(kRows, 0.3);
  CHECK((expected_position(still, kStep, kQuiet).col(0) - still).isZero(1e-12));
}

TEST_CASE("of noise alone next to nothing is motion") {
  const VectorXd share = share_of_motion(read(VectorXd::Zero(kRows), 1e-4), kStep, kQuiet, 1000);
  REQUIRE(share.size() == 1000);
  CHECK(share.tail(900).mean() < 0.1);
  // A log too short to tell is taken as it is, and so is one that is sampled too slowly.
  CHECK(share_of_motion(VectorXd::Ones(100), kStep, kQuiet, 10) == VectorXd::Ones(10));
  CHECK(share_of_motion(read(VectorXd::Zero(kRows), 1e-4), 0.01, 60.0, 10) == VectorXd::Ones(10));
}

TEST_CASE(
    "a slow motion's acceleration is free of noise, and nothing rings where the filter falls") {
  const double omega = 2.0 * std::numbers::pi * 1.5;
  VectorXd q(kRows);
  for (Index k = 0; k < kRows; ++k)
    q(k) = 7e-3 * (1.0 - std::cos(omega * kStep * static_cast<double>(k)));
  const auto error = [&](const MatrixXd& position) {
    const VectorXd off =
        (differentiate(position, kStep, 18.0).qdd - differentiate(q, kStep, 18.0).qdd)
            .col(0)
            .segment(500, kRows - 1000);
    return std::sqrt(off.squaredNorm() / static_cast<double>(off.size())) / (7e-3 * omega * omega);
  };
  const VectorXd reading = read(q, 1e-6);
  // As it was read: 0.4 % of the acceleration, all of it faster than the motion.
  CHECK(error(reading) > 3e-3);
  // Planted: a filter that falls from one bin to the next leaves 2 % of it at that frequency.
  CHECK(error(expected_position(reading, kStep, kQuiet)) < 5e-4);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What is behind a gear, a gap or a loose sensor, against closed forms.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "identification/logs/dequantise.h"
#include "identification/subjects/effect_candidate.h"
#include "symbolic/effects/effects.h"

namespace {

using namespace sinew;
using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double step = 1e-3;

Recording moved_by(const VectorXd& acceleration) {
  const Index n = acceleration.size();
  Recording log;
  log.step = step;
  log.time = VectorXd::LinSpaced(n, 0.0, step * static_cast<double>(n - 1));
  log.q = log.qd = Eigen::MatrixXd::Zero(n, 1);
  log.qdd = acceleration;
  log.signals["jounce"] = log.signals["direction"] = Eigen::MatrixXd::Zero(n, 1);
  return log;
}

VectorXd column(const std::string& effect, const VectorXd& acceleration, const VectorXd& shape) {
  return effect_columns(Regressor(find_effect(effect)), moved_by(acceleration), 0, shape).col(0);
}

}  // namespace

TEST_CASE("a load behind an elastic gear swings as its transfer function says") {
  // Planted defect: with the rectangle rule instead of the trapezoidal one all four fail, 5 Hz
  // with 4.5 %.
  const double natural = 2.0 * std::numbers::pi * 9.0, damping = 0.07;
  for (const double hz : {2.0, 5.0, 9.0, 20.0}) {
    const double w = 2.0 * std::numbers::pi * hz;
    VectorXd acceleration(6000);
    for (Index k = 0; k < acceleration.size(); ++k)
      acceleration(k) = std::cos(w * step * static_cast<double>(k));
    const VectorXd found =
        column("gear_resonance", acceleration, Eigen::Vector2d(natural, damping));
    const std::complex<double> i(0.0, 1.0);
    const std::complex<double> gain =
        w * w / (natural * natural - w * w + 2.0 * damping * natural * w * i);
    double worst = 0.0;
    for (Index k = 4000; k < found.size(); ++k)  // the beginning has died away
      worst = std::max(
          worst,
          std::abs(found(k) - std::real(gain * std::exp(i * w * step * static_cast<double>(k)))));
    INFO(hz << " Hz");
    CHECK(worst < 0.01 * std::abs(gain));
  }
}

TEST_CASE("a log begins with the load carried by its spring or by a side of its gap") {
  // Seen red with states that begin unloaded (0 and the first side): the weight swings for seconds,
  // or falls through the gap first. And where the first sample's acceleration, which a log's end
  // spoils, counted as well.
  Recording log = moved_by(VectorXd::Zero(2000));
  log.qdd(0, 0) = 30.0;
  for (const double parting : {-40.0, 40.0}) {
    log.signals["parting"] = Eigen::MatrixXd::Constant(2000, 1, parting);
    log.signals["parting"](0, 0) += log.qdd(0, 0);
    log.signals["carried_inertia"] = Eigen::MatrixXd::Ones(2000, 1);
    const auto from_rest = [&](const std::string& effect, const VectorXd& shape) {
      return effect_columns(Regressor(find_effect(effect)), log, 0, shape).col(0);
    };
    INFO("parting " << parting);
    const VectorXd spring = from_rest("link_resonance", Eigen::Vector2d(30.0, 0.02));
    CHECK(spring.tail(1990).cwiseAbs().maxCoeff() < 2.0);
    // Through the gap it would be hit with 290 rad/s^2.
    const VectorXd gap = from_rest("link_backlash", Eigen::Vector2d(2e-3, 0.6));
    CHECK(gap.tail(1990).cwiseAbs().maxCoeff() < 50.0);
  }
}

TEST_CASE("a load in a gap flies on, is hit and goes with the motor") {
  // Planted defect: without the impact (the motor's own acceleration in the gap alone) the load
  // never gets the motor's speed: the sum and the bouncing fail.
  const double gap = 2e-3, a = -3.0;
  VectorXd acceleration = VectorXd::Zero(400);
  acceleration.segment(20, 50).setConstant(a);  // away from the side it lies at
  const VectorXd found = column("inertial_backlash", acceleration, Eigen::Vector2d(gap, 0.0));
  const auto flight = static_cast<Index>(std::sqrt(2.0 * gap / -a) / step);
  CHECK(found.segment(0, 20).isZero(0.0));
  CHECK(found.segment(20, flight - 2).isApprox(VectorXd::Constant(flight - 2, a), 1e-12));
  CHECK(found.segment(20 + flight + 2, 100).isZero(1e-9));
  CHECK(std::abs(found.sum() * step) < 1e-12);  // both move alike in the end
  const VectorXd bouncing = column("inertial_backlash", acceleration, Eigen::Vector2d(gap, 0.6));
  CHECK(bouncing.segment(20, flight - 2).isApprox(found.segment(20, flight - 2), 1e-12));
  CHECK(bouncing.cwiseAbs().maxCoeff() > 1.5 * found.cwiseAbs().maxCoeff());
}

TEST_CASE("a load in a gap goes where its own force takes it") {
  // Planted defect: with the force left out nothing ever leaves the first side, and the flight and
  // its end fail.
  const double gap = 2e-3, mobility = 8.0, force = -0.5;
  Recording log = moved_by(VectorXd::Zero(400));
  log.load = Eigen::MatrixXd::Zero(400, 1);
  log.load.bottomRows(360).setConstant(force);
  const VectorXd found = effect_columns(Regressor(find_effect("loaded_backlash")), log, 0,
                                        Eigen::Vector3d(gap, mobility, 0.0))
                             .col(0);
  const auto flight = static_cast<Index>(std::sqrt(2.0 * gap / -(mobility * force)) / step);
  CHECK(found.segment(0, 40).isZero(0.0));
  CHECK(found.segment(40, flight - 2)
            .isApprox(VectorXd::Constant(flight - 2, mobility * force), 1e-12));
  CHECK(found.segment(40 + flight + 2, 100).isZero(1e-9));
  CHECK(std::abs(found.sum() * step) < 1e-12);
  // Under no load it is the other description of the same gap.
  VectorXd shaken(400);
  for (Index k = 0; k < shaken.size(); ++k)
    shaken(k) = 5.0 * std::sin(0.05 * static_cast<double>(k));
  CHECK(column("loaded_backlash", shaken, Eigen::Vector3d(gap, mobility, 0.3)) ==
        column("inertial_backlash", shaken, Eigen::Vector2d(gap, 0.3)));
}

TEST_CASE("the true motion is the reading plus where in its play the sensor is") {
  // Planted defect: with a straight way across the play the error is half of its half.
  const double half = 5e-4;
  for (const double quantum : {1e-6, 0.0}) {
    VectorXd truth(4000), reading(4000), rate(4000);
    double held = -half;
    for (Index k = 0; k < truth.size(); ++k) {
      const double phase = 3.0 * step * static_cast<double>(k);
      truth(k) = 0.05 * std::sin(phase);
      held = std::clamp(held, truth(k) - half, truth(k) + half);
      reading(k) = quantum > 0.0 ? quantum * std::round(held / quantum) : held;
      rate(k) = k > 0 ? (reading(k) - reading(k - 1)) / step : 0.15;
    }
    const VectorXd side = side_of_play(reading, rate, quantum, 1e-4);
    const VectorXd error = reading + half * side - truth;
    INFO("quantum " << quantum);
    CHECK(error.tail(3500).cwiseAbs().maxCoeff() < 0.15 * half);
  }
}

TEST_CASE("a resonance without damping is a line of the spectrum and no gear") {
  // Planted defect: without `above` at the damping ratio (gear_elasticity.cpp) it is one.
  const Candidate gear = effect_candidate(find_effect("gear_resonance"), {0, "motor", true},
                                          {-1.0, 1.0, 5.0, 0.0, 10.0, 1.0});
  REQUIRE(gear.possible);
  const Eigen::VectorXd coefficient = Eigen::VectorXd::Ones(1);
  CHECK(gear.possible(coefficient, Eigen::Vector2d(100.0, 0.05)));
  CHECK_FALSE(gear.possible(coefficient, Eigen::Vector2d(100.0, 0.01)));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/thinned_recording.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace {

using namespace sinew::diagnosis;
using Eigen::VectorXd;

int factor_of(double rate_hz, double band_hz) {
  return thinning_filter(1.0 / rate_hz, band_hz).factor;
}

}  // namespace

TEST_CASE("a log keeps six samples a period of what is compared and of the motion") {
  CHECK(factor_of(3000.0, 60.0) == 8);
  CHECK(factor_of(1000.0, 60.0) == 2);
  CHECK(factor_of(500.0, 60.0) == 1);
  CHECK(factor_of(1000.0, 18.0) == 2);  // the motion has 60 Hz
  CHECK(factor_of(1000.0, 80.0) == 2);
  CHECK(factor_of(1000.0, 100.0) == 1);
  CHECK(factor_of(95.0, 9.5) == 1);
}

TEST_CASE("the highest frequency compared is that of the channel with the widest band") {
  Recording log;
  Settings settings;
  settings.band_hz = 60.0;
  CHECK(highest_compared(log, settings) == 60.0);
  log.band_hz = {18.0, 40.0};
  CHECK(highest_compared(log, settings) == 40.0);
  settings.band_hz = 25.0;
  CHECK(highest_compared(log, settings) == 25.0);
}

// Seen red with every sixth sample as it is: all of the fast part was left; and planted: no
// payload_effort.
TEST_CASE("a thinned log has all that the log has, at its instants") {
  constexpr Eigen::Index rows = 10000;
  constexpr double step = 0.0004, slow_hz = 7.0, fast_hz = 480.0;
  const auto wave = [&](const VectorXd& time, double hz) -> VectorXd {
    return (2.0 * std::numbers::pi * hz * time.array()).sin();
  };
  Recording log;
  log.name = "a.csv part 2";
  log.log = "a.csv";
  log.step = step;
  log.log_start = 0.5;
  log.time = VectorXd::LinSpaced(rows, 1.0, 1.0 + step * (rows - 1));
  log.q = wave(log.time, slow_hz) + 0.3 * wave(log.time, fast_hz);
  log.qd = 2.0 * log.q;
  log.qdd = log.load = log.command = log.temperature = log.payload_effort = log.q;
  log.payload = log.q.col(0);
  log.target = {log.q.col(0)};
  log.known = {log.q.col(0)};
  log.signals["direction"] = log.q;
  log.signals[effort_of_logged_motion] = log.q;
  log.band_hz = {18.0};
  log.standstills = {{{1.0, 1.5}}};
  log.disturbed = {{2.0, 2.5}};
  const DecimatingFilter filter = thinning_filter(step, 18.0);
  const Recording thin = thinned(log, filter);
  REQUIRE(filter.factor == 6);
  CHECK(thin.name == log.name);
  CHECK(thin.log == log.log);
  CHECK(thin.step == Approx(0.0024));
  CHECK(thin.started() == 0.5);
  CHECK(thin.band_hz == log.band_hz);
  CHECK(thin.standstills.size() == 1);
  CHECK(thin.disturbed.size() == 1);
  CHECK(thin.time(0) == Approx(log.time(centre_sample(filter, 0))));
  const VectorXd slow = wave(thin.time, slow_hz);
  for (const auto& x : {thin.q, thin.qdd, thin.load, thin.command, thin.temperature,
                        thin.payload_effort, thin.signals.at("direction")}) {
    REQUIRE(x.rows() == slow.size());
    CHECK((x - slow).cwiseAbs().maxCoeff() < 2e-3);
  }
  CHECK((thin.qd - 2.0 * slow).cwiseAbs().maxCoeff() < 4e-3);
  for (const VectorXd& x : {thin.payload, thin.target[0], thin.known[0]})
    CHECK((x - slow).cwiseAbs().maxCoeff() < 2e-3);
  CHECK(thin.signals.find(effort_of_logged_motion) == nullptr);
}

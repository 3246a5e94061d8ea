// SPDX-License-Identifier: GPL-3.0-or-later
// One column's own factor or sign is told; what a machine lacks is none.
#include "identification/subjects/channel_factors.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <functional>
#include <string>
#include <vector>

#include "tests/identification/subjects/judged_arm.h"
#include "tests/identification/subjects/tendon_finger_log.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;
using namespace sinew::test;
using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;

std::vector<DataFault> stops(const Mechanism& nominal, const ArmLog& logged) {
  return faults_of(nominal, logged, &diagnosis::judge_effort_factors);
}

/// What stops a finger's log in which every force has a little noise.
std::vector<DataFault> stops(const TendonFingerLog& finger,
                             const std::function<void(Recording&)>& plant) {
  const Recording r = finger.with([&](Recording& log) {
    reference::RandomNumbers random(7);
    for (double& f : log.signals["tension"].reshaped()) f += random.uniform(-0.05, 0.05);
    plant(log);
  });
  FaultList faults("log.csv");
  judge_force_factors(finger.log(), finger.columns(), r, finger.model(), finger.effort(), faults);
  return faults.all();
}

}  // namespace

TEST_CASE("a factor or a sign of one effort is told with its column") {
  // Planted defect, seen to fail: kBeyond 1e9 in channel_factors.cpp lets the factors pass.
  const Mechanism arm = arm_of_five();
  for (const int joint : {1, 2, 4})
    for (const double factor : {3.0, 0.5, 50.0, -1.0}) {
      INFO("joint " << joint << ", times " << factor);
      ArmLog log = draw_log(arm, 1, {});
      log.tau.col(joint - 1) *= factor;
      const std::vector<DataFault> faults = stops(arm, log);
      REQUIRE(faults.size() == 1);
      CHECK(faults.front().channel == fmt::format("tau_j{}", joint));
      CHECK(faults.front().kind ==
            (factor < 0.0 ? FaultKind::reversed_sign : FaultKind::unit_slip));
    }
}

TEST_CASE("an arm that lacks friction, a load or a mass has no factor of its own") {
  // Planted defect, seen to fail: with others_are_right() always true the hand of twice the mass is
  // told as the unit of its joint's effort.
  const Mechanism nominal = arm_of_five();
  Mechanism loaded = nominal;
  loaded.bodies.back().mass *= 2.0;
  loaded.bodies.back().inertia *= 2.0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    INFO("seed " << seed);
    CHECK(stops(nominal, draw_log(nominal, seed, {0.5, 0.3})).empty());
    CHECK(stops(nominal, draw_log(loaded, seed, {0.5, 0.3})).empty());
    CHECK(stops(nominal, draw_log(loaded, seed, {})).empty());
  }
}

TEST_CASE("a factor or a sign of one force is told with its column") {
  // Planted defect, seen to fail: with the force that is furthest off instead of the one without
  // which the others are right, the antagonist is told.
  const TendonFingerLog finger;
  for (const Index tendon : {0, 2, 5})
    for (const double factor : {3.0, 0.5, -1.0}) {
      INFO("force " << tendon + 1 << ", times " << factor);
      const std::vector<DataFault> faults =
          stops(finger, [&](Recording& r) { r.signals["tension"].col(tendon) *= factor; });
      REQUIRE(faults.size() == 1);
      CHECK(faults.front().channel == fmt::format("force_{}", tendon + 1));
    }
}

TEST_CASE("a finger with a weak sensor, friction or an offset has no factor of its own") {
  const TendonFingerLog finger;
  const auto force = [](Recording& r) -> MatrixXd& { return r.signals["tension"]; };
  CHECK(stops(finger, [](Recording&) {}).empty());
  CHECK(stops(finger, [&](Recording& r) { force(r).col(2) *= 1.4; }).empty());
  CHECK(stops(finger, [&](Recording& r) { force(r).col(2).array() += 8.0; }).empty());
  CHECK(stops(finger, [&](Recording& r) {
          force(r).col(3).array() *= 1.0 + 0.2 * (r.qd.col(2).array() / 0.02).tanh();
        }).empty());
}

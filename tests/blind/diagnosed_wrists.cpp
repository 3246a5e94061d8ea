// SPDX-License-Identifier: GPL-3.0-or-later
// Sealed trials on logs of a moving wrist: the program gets the nominal values and the logs alone;
// the seal is opened after the verdict.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numeric>

#include "identification/subjects/wrist_subject.h"
#include "tests/blind/diagnosed_trial.h"

namespace {

using namespace sinew;
using blind::Outcome;

/// The first eight tendons of models/wrist.
WristParameters nominal_wrist(const truth::Trial& trial) {
  const auto values = nlohmann::json::parse(trial.nominal);
  const auto number = [&](const char* key) { return values.at(key).get<double>(); };
  WristParameters wrist;
  wrist.length = number("a");
  wrist.width = number("b");
  wrist.thickness = number("c");
  wrist.motor_radius = number("motor_radius");
  wrist.flexion = {-0.5, 0.5};
  wrist.abduction = {-0.3, 0.3};
  const double forearm[] = {7, 8, 10, 11, 13, 15, 16, 18};
  const double palm[] = {-11, -10, -8, -6, -5, -3, -2, 0};
  for (int i = 0; i < 8; ++i) {
    wrist.forearm_points.emplace_back(0.004, 1e-3 * forearm[i], 0.008);
    wrist.palm_points.emplace_back(-0.004, 1e-3 * palm[i], 0.010);
  }
  return wrist;
}

Outcome diagnose_wrist(const truth::TrialRequest& trial) {
  return blind::diagnose_rig(
      trial,
      [](const truth::Trial& open) {
        std::vector<int> tendons(8);
        std::iota(tendons.begin(), tendons.end(), 1);
        return diagnosis::wrist_rig(nominal_wrist(open), "wrist", tendons);
      },
      blind::by_table({{"coupling left uncompensated", "wrist_coupling"},
                       {"zero offset", "wrist_zero"},
                       {"contact-point shift", "contact_shift"},
                       {"scale of the angle sensor", "sensor_scale"},
                       {"quantisation of the angle sensor", "sensor_quantisation"}}));
}

}  // namespace

TEST_CASE("causes hidden in a wrist's log are named", "[slow]") {
  const blind::Rates rates =
      blind::run(diagnose_wrist, {100, "wrist", truth::Family::one, 1.0}, 1,
                 [](std::uint64_t seed, const Outcome& o) {
                   WARN(seed << " hidden:" << o.hidden() << ", told:" << o.told());
                 });
  INFO(rates.text());
  CHECK(rates.all_inside == 1);
}

TEST_CASE("a wrist that hides nothing is told to leave nothing over", "[slow]") {
  const blind::Rates rates =
      blind::run(diagnose_wrist, {100, "wrist", truth::Family::nothing, 1.0}, 1);
  INFO(rates.text());
  CHECK(rates.false_names == 0);
}

TEST_CASE("what the library lacks at one motor of a wrist is no noise", "[slow][thorough]") {
  // A motor with play. Planted defect: with the dependences that all motors share alone
  // (complete() in wrist_subject.cpp) its play is told as noise.
  const Outcome o = diagnose_wrist({307, "wrist", truth::Family::outside, 10.0});
  INFO("hidden:" << o.hidden() << ", told:" << o.told());
  REQUIRE(o.hides("loose", "motor 5", 10.0));
  CHECK(o.findings.verdict.unexplained.none_of_the_known);
  CHECK(o.false_names == 0);
}

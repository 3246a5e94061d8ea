// SPDX-License-Identifier: GPL-3.0-or-later
// Sealed trials on drives: the program gets the model's nominal values and the logs alone; the seal
// is opened after the verdict. A few in every run, so that each path is gone; rates are
// scripts/study's.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

#include "identification/subjects/driven_channels.h"
#include "tests/blind/diagnosed_trial.h"

namespace {

using namespace sinew;
using blind::Outcome;

/// The model under test from its nominal values.
DrivenModel nominal_model(const truth::Trial& trial) {
  const auto values = nlohmann::json::parse(trial.nominal);
  const auto number = [&](const char* key) { return values.at(key).get<double>(); };
  if (trial.plant == "drive") {
    MotorParameters motor;
    motor.gear_ratio = number("motor_turn") / (2.0 * std::numbers::pi);
    motor.gearbox_inertia = number("inertia");
    motor.torque_constant = 1.0;
    motor.gamma1 = number("friction_shape");
    motor.gamma2 = number("friction_level");
    motor.gamma3 = number("viscous");
    return driven_model(motor, "drive");
  }
  Mechanism slide;
  slide.name = "slide";
  Body body;
  body.name = "carriage";
  body.mass = number("inertia");
  Joint joint;
  joint.name = "x";
  joint.type = JointType::prismatic;
  joint.damping = number("viscous");
  joint.friction = number("friction_level") * std::numbers::pi / 2.0;
  joint.friction_speed = 1.0 / number("friction_shape");
  joint.motor_turn = number("motor_turn");
  slide.bodies = {body};
  slide.joints = {joint};
  slide.gravity.setZero();
  return driven_model(slide);
}

std::string word(const std::string& name, const std::string& place) {
  static const blind::Words table =
      blind::by_table({{"viscous friction level", "viscous_level"},
                       {"Coulomb friction level", "coulomb_level"},
                       {"viscous asymmetry", "direction_asymmetry"},
                       {"Coulomb friction asymmetry", "direction_asymmetry"},
                       {"Stribeck friction", "stribeck"},
                       {"friction concave in speed", "concave_friction"},
                       {"load-dependent friction", "load_friction"},
                       {"slow drift of friction", "friction_drift"},
                       {"gear elasticity", "gear_elasticity"},
                       {"torque constant", "torque_constant"},
                       {"low-pass of the position sensor", "sensor_low_pass"},
                       {"scale of the position sensor", "sensor_scale"},
                       {"hysteresis of the position sensor", "sensor_hysteresis"},
                       {"quantisation of the position sensor", "sensor_quantisation"}});
  if (name.rfind("ripple proportional to load", 0) == 0) return "load_ripple";
  if (name.rfind("ripple", 0) == 0)
    return name.find("motor") != std::string::npos ? "input_ripple" : "output_ripple";
  return table(name, place);
}

diagnosis::DiagnoseRequest drive_request(const truth::Trial& open) {
  diagnosis::DiagnoseRequest request;
  request.model = nominal_model(open);
  const bool revolute = open.plant == "drive";
  request.channels = [revolute](const std::string&) {
    return diagnosis::drive_log_channels(revolute, {});
  };
  return request;
}

Outcome diagnose_drive(const truth::TrialRequest& trial) {
  return blind::diagnose_driven(trial, drive_request, word);
}

blind::Settled settle_drive(const truth::TrialRequest& trial) {
  return blind::settle_driven(trial, drive_request, word);
}

}  // namespace

TEST_CASE("causes hidden in drives are named from the logs alone", "[slow]") {
  // Seeds in a row, one cause each as large as the noise. docs/blind_trials.md has the rates of
  // many more; this is to see that they have not become worse. Planted defect: without
  // look_at_standstills (diagnose.cpp) seed 2005, a sensor's play, is told to hide nothing; with
  // set_bands cutting every noisy joint's band seed 2006, a sensor's steps.
  const blind::Rates rates =
      blind::run(diagnose_drive, {2003, "drive", truth::Family::one, 1.0}, 6,
                 [](std::uint64_t seed, const Outcome& o) {
                   WARN(seed << " hidden:" << o.hidden() << ", told:" << o.told());
                   if (seed == 2005) CHECK(o.hides("sensor_hysteresis", "sensor", 1.0));
                   if (seed == 2006) CHECK(o.hides("sensor_quantisation", "sensor", 1.0));
                 });
  INFO(rates.text());
  CHECK(rates.detected == 6);
  CHECK(rates.all_inside >= 5);
}

TEST_CASE("causes that were missed once are found", "[slow][thorough]") {
  // A load that falls through the gap (90032: without "loaded_backlash" in add_library it is called
  // gear elasticity), and a nuisance fitted to nothing that ruins held-out stretches (400030:
  // without settle_nuisances in select.cpp nothing is said). A sensor's low-pass that logs
  // bend as, told as a delay (450067: without with_lag in confounding.cpp), and a sensor's play
  // beside which half a sample of its own making was told as a delay (460065: side_of_play not
  // centred).
  struct Missed {
    std::uint64_t seed;
    const char *cause, *place;
  };
  for (const auto& [seed, cause, place] :
       {Missed{90032, "backlash", "motor"}, Missed{400030, "viscous_level", "motor"},
        Missed{450067, "sensor_low_pass", "sensor"},
        Missed{460065, "sensor_hysteresis", "sensor"}}) {
    const Outcome o = diagnose_drive({seed, "drive", truth::Family::one, 1.0});
    INFO("seed " << seed << " hidden:" << o.hidden() << ", told:" << o.told());
    REQUIRE(o.hides(cause, place, 1.0));
    CHECK(o.all_right);
  }
}

TEST_CASE("what one log cannot tell apart the motion asked for does", "[slow][thorough]") {
  // Pairs that look the same in the logs handed over. 443001 also needs the held-out gain of load
  // friction beside the friction level as adopted: held-out logs under one load show none beside a
  // deviation that is free (seen to fail with gain_on_held_out of the search's model alone).
  int settled = 0;
  struct Pair {
    std::uint64_t seed;
    const char *cause, *rival;
  };
  for (const auto& [seed, cause, rival] : {Pair{443001, "load_friction", "coulomb_level"},
                                           Pair{444001, "viscous_level", "coulomb_level"}}) {
    const blind::Settled s = settle_drive({seed, "drive", truth::Family::inseparable, 1.0});
    INFO("seed " << seed << " hidden:" << s.before.hidden() << ", told:" << s.before.told());
    REQUIRE(s.before.hides(cause, "motor", 1.0));
    REQUIRE_THAT(s.before.seal.admissible, Catch::VectorContains(std::string(rival)));
    CHECK(s.before.members > 1);
    REQUIRE(s.after);
    INFO("then told:" << s.after->told());
    settled += s.after->is_settled();
  }
  CHECK(settled == 2);
}

TEST_CASE("a drive that hides nothing is told to leave nothing over", "[slow]") {
  const blind::Rates rates =
      blind::run(diagnose_drive, {5000, "drive", truth::Family::nothing, 1.0}, 3,
                 [](std::uint64_t seed, const Outcome& o) {
                   INFO("seed " << seed << ", told:" << o.told());
                   CHECK_FALSE(o.findings.extension.adopted);
                 });
  INFO(rates.text());
  CHECK(rates.false_names == 0);
}

TEST_CASE("a cause outside the library is structure without a name", "[slow]") {
  // Tight spots, soft stops, hums, friction that swings or remembers: nothing the library has.
  // Planted defect: with the flexible families left out of the screening (Scope::nameable in
  // unexplained.cpp) two of these get a wrong name and one is not seen.
  const blind::Rates rates =
      blind::run(diagnose_drive, {3000, "drive", truth::Family::outside, 1.0}, 6,
                 [](std::uint64_t seed, const Outcome& o) {
                   WARN(seed << " hidden:" << o.hidden() << ", told:" << o.told());
                 });
  INFO(rates.text());
  CHECK(rates.none_of_the_known >= 5);
  CHECK(rates.trials_with_false_name <= 1);
}

TEST_CASE("a cause of which neither size nor form is known is not named", "[slow]") {
  // A hum. Planted defect: without drop_undetermined (select.cpp) it is a backlash whose gap is
  // known to 4e7 rad.
  const Outcome o = diagnose_drive({310015, "drive", truth::Family::outside, 1.0});
  INFO("hidden:" << o.hidden() << ", told:" << o.told());
  REQUIRE(o.hides("hum", "motor", 1.0));
  CHECK(o.findings.verdict.causes.empty());
  CHECK(o.findings.verdict.unexplained.none_of_the_known);
}

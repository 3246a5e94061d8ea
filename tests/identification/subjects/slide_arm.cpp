// SPDX-License-Identifier: GPL-3.0-or-later
// An arm on a slide, whose drives its model does not know: a mass that the slide moves is as good
// as a rotor of the slide, and so on up the arm.
#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

#include "symbolic/effects/model_effects.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/model/pseudo_inertia.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/identification/subjects/diagnosed_robot.h"

using namespace sinew;
using namespace sinew::test;
using diagnosis::Findings;
using diagnosis::NamedCause;

namespace {

/// A carriage that slides along x, and two links in a vertical plane on it.
Mechanism slide_arm() {
  Mechanism arm = upper_and_lower_arm();
  Joint slide;
  slide.name = "j0";
  slide.type = JointType::prismatic;
  slide.axis = {1.0, 0.0, 0.0};
  Body carriage;
  carriage.name = "l0";
  carriage.mass = 7.0;
  carriage.inertia = 0.03 * Eigen::Matrix3d::Identity();
  arm.joints.insert(arm.joints.begin(), slide);
  arm.bodies.insert(arm.bodies.begin(), carriage);
  for (int i = 0; i < 3; ++i) {
    arm.joints[static_cast<std::size_t>(i)].parent = i - 1;
    arm.joints[static_cast<std::size_t>(i)].name = "j" + std::to_string(i + 1);
    arm.bodies[static_cast<std::size_t>(i)].name = "l" + std::to_string(i + 1);
  }
  return arm;
}

std::string slide_csv(const ArmLog& log) {
  const std::string text = std::regex_replace(csv(log), std::regex("q_j1 .rad."), "q_j1 [m]");
  return std::regex_replace(text, std::regex("tau_j1 .N.m."), "tau_j1 [N]");
}

/// Links a few per cent off their drawing.
Mechanism as_built(Mechanism arm) {
  arm.bodies[0].mass *= 0.98;
  arm.bodies[1].mass *= 0.96;
  arm.bodies[1].inertia *= 0.96;
  arm.bodies[1].centre_of_mass += Eigen::Vector3d(-0.006, 0.0, -0.003);
  arm.bodies[2].mass *= 1.03;
  arm.bodies[2].inertia *= 1.03;
  arm.bodies[2].centre_of_mass += Eigen::Vector3d(0.003, 0.0, 0.002);
  return arm;
}

double value_of(const NamedCause& cause, const std::string& name) {
  for (const auto& p : cause.parameters)
    if (p.name == name) return p.value;
  return 0.0;
}

}  // namespace

TEST_CASE("rotors beside links that are a little off are no other links and no payload",
          "[slow][thorough]") {
  // Planted defects, each seen to fail: kOwnSpread at 1e3 (rigid_candidates.cpp; links of thrice
  // their mass stand for the rotors), hold_bodies() without effect (no rotor gains anything beside
  // links that may be anything).
  const Mechanism drawn = slide_arm(), built = as_built(drawn);
  const ArmFriction drives{0.8, 1.2, {6.0, 0.3, 0.08}};
  const auto log = [&](std::uint64_t seed) {
    return slide_csv(draw_log(built, seed, drives, 0.004, 30.0));
  };
  const Findings found = diagnosed(drawn, log(1), log(2));
  INFO(found.headline);
  double rotors[3] = {0.0, 0.0, 0.0};
  for (const NamedCause& cause : found.verdict.causes) {
    const auto& first = cause.members.front();
    INFO(first.name << ", " << first.place);
    if (first.name == find_model_effect("payload")->name)
      CHECK(std::abs(value_of(cause, "mass")) < 0.1 * drawn.bodies[2].mass);
    for (std::size_t i = 0; i < 3; ++i) {
      if (first.name == "inertia" && first.place == "joint " + drawn.joints[i].name)
        rotors[i] = value_of(cause, "inertia_change");
      if (first.place == "link " + drawn.bodies[i].name)
        CHECK(std::abs(value_of(cause, "mass")) < 0.3 * drawn.bodies[i].mass);
    }
  }
  // A slide feels its rotor and what all links are off together.
  CHECK(rotors[0] == Approx(6.0).margin(0.5));
  CHECK(rotors[1] == Approx(0.3).epsilon(0.1));
  CHECK(rotors[2] == Approx(0.08).epsilon(0.1));
  CHECK(found.extension.adopted);
  // What is left is hardly more than the true model leaves.
  const Findings true_model = diagnosed(built, log(1), log(2));
  for (std::size_t j = 0; j < found.channels.size(); ++j)
    CHECK(found.channels[j].domains.front().after <
          1.5 * true_model.channels[j].domains.front().after);
}

TEST_CASE("friction that the model lacks is adopted as it is beside a torque constant that is off",
          "[slow]") {
  // The model divides all of a joint's effort by the constant's change. Planted defect: without
  // put_before_gains() (extend.cpp) the friction is a fifth too large.
  const Mechanism arm = upper_and_lower_arm();
  const ArmFriction friction{1.5, 0.5};
  const auto log = [&](std::uint64_t seed) {
    ArmLog drawn = draw_log(arm, seed, friction, 0.004, 30.0);
    drawn.tau.col(0) *= 1.2;
    return csv(drawn);
  };
  const diagnosis::Diagnosis found = whole_diagnosis(arm, log(1), log(2));
  INFO(found.findings.headline);
  CHECK(found.findings.extension.adopted);
  const auto learnt = [&](const std::string& effect, const std::string& value) {
    for (const IdentifiedEffect& e : found.extended.effects)
      if (e.effect == effect && e.place == "j1") return e.coefficient(value);
    return 0.0;
  };
  CHECK(learnt("torque_constant", "gain_change") == Approx(1.0 / 1.2 - 1.0).epsilon(0.01));
  CHECK(learnt("coulomb_level", "level_change") == Approx(friction.coulomb).epsilon(0.01));
  CHECK(learnt("viscous_level", "viscous_change") == Approx(friction.viscous).epsilon(0.03));
}

TEST_CASE("a payload beside a drawing that is off is a body, and the link takes the rest",
          "[slow][thorough]") {
  // What the last link's drawing has too much makes what is told of a point's moments less than
  // those of a point. Planted defect: no errors of drawings (physical_links.cpp): the nearest body
  // leaves a tenth more over at the last joint.
  Mechanism drawn = slide_arm(), built = as_built(drawn);
  for (Mechanism* arm : {&drawn, &built}) {  // what is not asked about here
    arm->bodies[0].mass = 7.0;
    arm->bodies[1] = drawn.bodies[1];
  }
  Body& last = built.bodies[2];
  last.mass = 0.85 * drawn.bodies[2].mass;
  last.inertia = 0.8 * drawn.bodies[2].inertia;
  const Eigen::Vector4d point(0.02, 0.0, 0.3, 1.0);
  set_pseudo_inertia(body_pseudo_inertia(last) + 1.2 * point * point.transpose(), last);
  const ArmFriction drives{0.8, 1.2, {6.0, 0.3, 0.08}};
  const auto log = [&](std::uint64_t seed) {
    return slide_csv(draw_log(built, seed, drives, 0.004, 30.0));
  };
  const diagnosis::Diagnosis found = whole_diagnosis(drawn, log(1), log(2));
  INFO(found.findings.headline << "\n" << found.findings.extension.reason);
  REQUIRE(found.findings.extension.adopted);
  CHECK_THAT(found.findings.extension.reason, Catch::Contains("the drawing of link l3"));
  Eigen::Matrix4d payload = Eigen::Matrix4d::Zero(), own = payload;
  for (const IdentifiedEffect& e : found.extended.effects) {
    if (e.effect == "payload") payload += pseudo_inertia_of(e);
    if (e.effect == "inertial_parameters") own += pseudo_inertia_of(e);
  }
  CHECK(is_physical(payload));
  CHECK(is_physical(body_pseudo_inertia(drawn.bodies[2]) + own));
  CHECK(payload(3, 3) == Approx(1.05).margin(0.2));
  const Findings true_model = diagnosed(built, log(1), log(2));
  for (std::size_t j = 0; j < found.findings.channels.size(); ++j)
    CHECK(found.findings.channels[j].domains.front().after <
          1.03 * true_model.channels[j].domains.front().after);
}

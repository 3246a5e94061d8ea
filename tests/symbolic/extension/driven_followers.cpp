// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "symbolic/extension/driven_model.h"
#include "symbolic/model/read_mechanism.h"

using namespace sinew;

TEST_CASE("a joint that follows another one leaves its losses to that one") {
  // Planted defect: the independent joint's own damping alone.
  Mechanism ring = read_mechanism(SINEW_SOURCE_DIR "/models/ring");
  REQUIRE(ring.couplings.size() == 1);
  const JointCoupling& coupling = ring.couplings.front();
  const auto joint = [&](const std::string& name) -> Joint& {
    for (Joint& each : ring.joints)
      if (each.name == name) return each;
    throw std::out_of_range(name);
  };
  joint(coupling.independent).damping = 1e-4;
  joint(coupling.dependent).damping = 3e-4;
  joint(coupling.dependent).armature = 2e-6;
  joint(coupling.dependent).friction = 1e-3;
  const DrivenModel model = driven_model(ring);
  for (const DrivenJoint& driven : model.joints) {
    if (driven.name != coupling.independent) continue;
    const double ratio = coupling.ratio;
    CHECK(driven.damping == Approx(1e-4 + ratio * ratio * 3e-4));
    CHECK(driven.armature == Approx(joint(driven.name).armature + ratio * ratio * 2e-6));
    CHECK(driven.friction == Approx(joint(driven.name).friction + std::abs(ratio) * 1e-3));
    return;
  }
  FAIL("the independent joint is not driven");
}

TEST_CASE("a drive's ripples are looked for at the orders of its poles, slots and teeth") {
  // Planted defect, seen to fail: poles taken for pairs of them.
  Mechanism ring = read_mechanism(SINEW_SOURCE_DIR "/models/ring");
  ring.joints.front().motor_poles = 14;
  ring.joints.front().motor_slots = 12;
  ring.joints.front().gear_teeth = 17;
  const std::vector<DrivenJoint> joints = driven_joints(ring);
  REQUIRE(joints.front().name == ring.joints.front().name);
  CHECK(joints.front().motor_orders == std::vector<int>{7, 14, 17, 42, 84});
  CHECK(joints.back().motor_orders.empty());

  MotorParameters motor;
  motor.gear_ratio = 0.01;
  motor.rotor_inertia = 1e-5;
  motor.torque_constant = 0.05;
  motor.input_ripple = {{6.0, 0.1, 0.0}, {2.5, 0.1, 0.0}, {1e30, 0.1, 0.0}};
  CHECK(driven_model(motor, "motor").joints.front().motor_orders == std::vector<int>{6});
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What a guide takes from a tendon's force: with the joints' motion, or with its motor's.
#include <catch2/catch.hpp>
#include <cmath>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/extension/driven_model.h"
#include "symbolic/model/read_mechanism.h"

using namespace sinew;

namespace {

/// Effort with a share of the tendon's force lost; `effect` at the index finger's first tendon.
struct Guided {
  std::optional<MotorParameters> motor;
  DrivenModel model;

  explicit Guided(bool motors) {
    if (motors) {
      motor.emplace();
      motor->gear_ratio = 100.0;
      motor->torque_constant = 1.0;
      motor->gearbox_inertia = 2e-3;
      motor->pulley_radius = 0.005;
    }
    model = tendon_driven_model(read_mechanism(SINEW_SOURCE_DIR "/models/index"), motor);
  }

  Function effort(const char* effect,
                  const IdentifiedValue& lost = {"friction_coefficient", 0.1, 0.0, "1"}) const {
    Identified identified;
    if (*effect)
      identified.effects.push_back({effect,
                                    tendon_place(model.tendons.names.front()),
                                    {{"bending_elsewhere", 1.0, 0.0, "rad"}},
                                    {lost}});
    return effort_function(model, identified);
  }
};

/// All inputs 0 but what is given: joint rates, motor rates, the tendons' tension.
std::vector<double> efforts(const Function& function, double joint_rate, double motor_rate,
                            double tension = 20.0) {
  std::vector<double> in;
  for (const Argument& argument : function.inputs)
    for (int i = 0; i < argument.rows * argument.cols; ++i) {
      double value = 0.0;
      if (argument.name == "qd") value = i < 4 ? joint_rate : motor_rate;
      if (argument.name == "tension") value = tension;
      in.push_back(value);
    }
  return evaluate(function, in);
}

}  // namespace

TEST_CASE("a guide loses force with the joints' motion or with the motor's") {
  const Guided finger(true);
  const Function plain = finger.effort("");
  const Function by_joints = finger.effort("guiding_friction");
  const Function by_motors = finger.effort("motor_side_guiding");
  const auto lost = [&](const Function& f, double joint_rate, double motor_rate) {
    const auto with = efforts(f, joint_rate, motor_rate),
               without = efforts(plain, joint_rate, motor_rate);
    double sum = 0.0;
    for (std::size_t i = 0; i < without.size(); ++i) sum += std::abs(with[i] - without[i]);
    return sum;
  };
  CHECK(lost(by_joints, 0.0, 2.0) == 0.0);
  CHECK(lost(by_joints, 1.0, 0.0) > 1e-3);
  CHECK(lost(by_motors, 1.0, 0.0) == 0.0);
  CHECK(lost(by_motors, 0.0, 2.0) > 1e-3);
}

TEST_CASE("where the tendon is taut both ends lose the same") {
  // The first tendon's length changes with the joints' rates as the motor's pulley takes it in.
  const Guided finger(true);
  const double joint_rate = 1.0;
  const Mechanism mechanism = read_mechanism(SINEW_SOURCE_DIR "/models/index");
  double rate = 0.0;
  for (const PulleyRouting& pulley : mechanism.tendons.front().pulleys)
    rate += pulley.radius * joint_rate;
  const double motor_rate = -rate / finger.motor->pulley_radius;
  const std::vector<double> joints =
      efforts(finger.effort("guiding_friction"), joint_rate, motor_rate);
  const std::vector<double> motors =
      efforts(finger.effort("motor_side_guiding"), joint_rate, motor_rate);
  const std::vector<double> unguided = efforts(finger.effort(""), joint_rate, motor_rate);
  REQUIRE(joints.size() == motors.size());
  CHECK(std::abs(joints[0] - unguided[0]) > 1e-3);
  for (std::size_t i = 0; i < joints.size(); ++i)
    CHECK(motors[i] == Approx(joints[i]).margin(1e-12));
}

TEST_CASE("a guide at a motor that is not in the model is refused") {
  const Guided finger(false);
  CHECK_THROWS_WITH(finger.effort("motor_side_guiding"),
                    Catch::Contains("needs the motors, which model"));
  CHECK_NOTHROW(finger.effort("guiding_friction"));
}

TEST_CASE("a sheath that presses by itself takes the same from a tendon at any force") {
  // Planted defect: the term with the tendon's force in it: twice as much is lost at 40 N.
  const Guided finger(false);
  const Function plain = finger.effort("");
  const auto lost = [&](const Function& f, double tension) {
    return efforts(f, 1.0, 0.0, tension)[0] - efforts(plain, 1.0, 0.0, tension)[0];
  };
  const Function sheath = finger.effort("guide_drag", {"friction_force", 2.0, 0.0, "N/rad"});
  const Function capstan = finger.effort("guiding_friction");
  CHECK(lost(capstan, 40.0) == Approx(2.0 * lost(capstan, 20.0)));
  CHECK(lost(sheath, 40.0) == Approx(lost(sheath, 20.0)));
  CHECK(lost(sheath, 20.0) == Approx(lost(capstan, 20.0)));  // 0.1 of 20 N
}

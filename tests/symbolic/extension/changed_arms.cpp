// SPDX-License-Identifier: GPL-3.0-or-later
// Moment arms that are not the drawing's, and a guide in which the tendon creeps before it slips.
#include <catch2/catch.hpp>
#include <cmath>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/extension/driven_model.h"
#include "symbolic/model/read_mechanism.h"

using namespace sinew;

namespace {

constexpr double kTension = 20.0;

struct Finger {
  DrivenModel model = tendon_driven_model(read_mechanism(SINEW_SOURCE_DIR "/models/index"), {});

  Function effort(const char* effect, std::vector<IdentifiedValue> coefficients,
                  std::vector<IdentifiedValue> shape = {}) const {
    Identified identified;
    if (*effect)
      identified.effects.push_back({effect, tendon_place(model.tendons.names.front()),
                                    std::move(shape), std::move(coefficients)});
    return effort_function(model, identified);
  }
};

/// Which of the model's joints is called so.
std::size_t number_of(const DrivenModel& model, const std::string& joint) {
  std::size_t j = 0;
  while (model.joints.at(j).name != joint) ++j;
  return j;
}

/// All inputs 0 but the joints' angles and rates, the first tendon's tension, the step and memory.
std::vector<double> outputs(const Function& function, double angle, double rate,
                            double memory = 0.0) {
  std::vector<double> in;
  for (const Argument& argument : function.inputs)
    for (int i = 0; i < argument.rows * argument.cols; ++i) {
      double value = 0.0;
      if (argument.name == "q") value = angle;
      if (argument.name == "qd") value = rate;
      if (argument.name == "tension" && i == 0) value = kTension;
      if (argument.name == "step") value = 1e-3;
      if (argument.name == "memory") value = memory;
      in.push_back(value);
    }
  return evaluate(function, in);
}

}  // namespace

TEST_CASE("a larger pulley of one tendon is more of its torque at every joint that it passes") {
  const Finger finger;
  const Function plain = finger.effort("", {}),
                 larger = finger.effort("tendon_radius", {{"radius_change", 0.1, 0.0, "1"}});
  const auto before = outputs(plain, 0.0, 0.0), after = outputs(larger, 0.0, 0.0);
  const Mechanism mechanism = read_mechanism(SINEW_SOURCE_DIR "/models/index");
  double joints = 0.0;
  for (const PulleyRouting& pulley : mechanism.tendons.front().pulleys) {
    const auto j = number_of(finger.model, pulley.joint);
    // -P^T f = rigid + 0.1 P^T f: the torque of the force as it is measured is 1.1 times the
    // model's.
    CHECK(after[j] - before[j] == Approx(0.1 * kTension * pulley.radius));
    ++joints;
  }
  CHECK(joints > 0.0);
}

TEST_CASE("a guide off its place changes the moment arms with the joint's angle") {
  const Finger finger;
  const Function plain = finger.effort("", {}),
                 off = finger.effort("routing_offset", {{"offset_across", 1e-3, 0.0, "m"},
                                                        {"offset_along", 2e-3, 0.0, "m"}});
  const Mechanism mechanism = read_mechanism(SINEW_SOURCE_DIR "/models/index");
  std::vector<bool> passed(4, false);
  for (const PulleyRouting& pulley : mechanism.tendons.front().pulleys)
    passed[number_of(finger.model, pulley.joint)] = true;
  for (const double angle : {0.0, 0.4}) {
    const auto before = outputs(plain, angle, 0.0), after = outputs(off, angle, 0.0);
    const double arm = 1e-3 * std::sin(angle) + 2e-3 * std::cos(angle);
    for (std::size_t j = 0; j < passed.size(); ++j)
      CHECK(after[j] - before[j] == Approx(passed[j] ? kTension * arm : 0.0).margin(1e-12));
  }
}

TEST_CASE("a guide's friction builds up over the way on which the tendon creeps") {
  const Finger finger;
  const std::vector<IdentifiedValue> shares{{"friction_coefficient", 0.1, 0.0, "1"}},
      length{{"bending_elsewhere", 1.0, 0.0, "rad"}, {"presliding_length", 1e-4, 0.0, "m"}},
      straight{{"bending_elsewhere", 1.0, 0.0, "rad"}};
  const Function creeps = finger.effort("guiding_presliding", shares, length),
                 slips = finger.effort("guiding_friction", shares, straight),
                 plain = finger.effort("", {});
  const auto lost = [&](const Function& f, double rate, double memory) {
    return outputs(f, 0.0, rate, memory)[0] - outputs(plain, 0.0, rate)[0];
  };
  // On a way of ten times the length it is full; on a tenth of it hardly begun.
  CHECK(lost(creeps, 1e3, 0.0) == Approx(lost(slips, 1e3, 0.0)).epsilon(1e-3));
  CHECK(std::abs(lost(creeps, 1e-3, 0.0)) < 0.05 * std::abs(lost(creeps, 1e3, 0.0)));
  // What the last sample left: it goes on from there.
  const double side = lost(creeps, 1e3, 0.0) > 0.0 ? 1.0 : -1.0;
  CHECK(std::abs(lost(creeps, 0.0, 1.0)) == Approx(side * lost(creeps, 1e3, 0.0)).epsilon(1e-3));
}

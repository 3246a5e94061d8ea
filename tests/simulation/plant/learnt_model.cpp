// SPDX-License-Identifier: GPL-3.0-or-later
// What was learnt decides of which driven model it is a part.
#include "simulation/plant/learnt_model.h"

#include <catch2/catch.hpp>

#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/model/read_mechanism.h"

using namespace sinew;

namespace {

DrivenModel with_guide(const char* effect) {
  const std::filesystem::path index = SINEW_SOURCE_DIR "/models/index";
  const Mechanism mechanism = read_mechanism(index);
  Identified identified;
  identified.effects.push_back({effect,
                                tendon_place(mechanism.tendons.front().name),
                                {{"bending_elsewhere", 1.0, 0.0, "rad"}},
                                {{"friction_coefficient", 0.1, 0.0, "1"}}});
  DrivenModel model = learnt_model(mechanism, identified, index);
  CHECK_NOTHROW(effort_function(model, identified));
  return model;
}

}  // namespace

TEST_CASE("a guide that goes with its motor brings the motors into the model") {
  // Seen to fail with motors by the entries' places alone: effort_function() refuses the guide, and
  // a diagnosis that had found one adopted nothing at all.
  CHECK(with_guide("motor_side_guiding").tendons.motor.has_value());
  CHECK_FALSE(with_guide("guiding_friction").tendons.motor.has_value());
}

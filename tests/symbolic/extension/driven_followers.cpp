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

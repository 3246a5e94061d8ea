// SPDX-License-Identifier: GPL-3.0-or-later
// An arm that is pushed now and then while no log has the force.
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "identification/subjects/rigid_candidates.h"
#include "tests/identification/subjects/arm_logs.h"
#include "tests/identification/subjects/diagnosed_robot.h"
#include "tests/reference/newton_euler.h"
#include "tests/reference/random_numbers.h"

namespace {

using namespace sinew;
using namespace sinew::test;
using diagnosis::Findings;
using diagnosis::NamedCause;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// A force in the base's frame [N] at a point of a link, from one time to another [s].
struct Push {
  std::size_t link = 0;
  Vector3d point, force;
  double from = 0.0, to = 0.0;
};

Mechanism with_point(Mechanism arm, const Push& push) {
  Frame frame;
  frame.name = "point";
  frame.body = arm.bodies[push.link].name;
  frame.pose.translation = push.point;
  arm.frames = {frame};
  return arm;
}

/// What the joints need not do while it pushes.
void apply(const Mechanism& arm, const Push& push, ArmLog& log) {
  const reference::NewtonEuler<double> numerics(with_point(arm, push));
  for (Index k = 0; k < log.q.rows(); ++k) {
    const double time = log.step * static_cast<double>(k);
    if (time < push.from || time > push.to) continue;
    const MatrixXd jacobian = numerics.tip_jacobian(log.q.row(k).transpose());
    log.tau.row(k) -= (jacobian.topRows(3).transpose() * push.force).transpose();
  }
}

const NamedCause* unlogged_force(const Findings& found) {
  for (const NamedCause& cause : found.verdict.causes)
    if (cause.members.front().name == "unlogged force") return &cause;
  return nullptr;
}

const Vector3d at_hand{0.15, 0.0, 0.0}, aside{1.6, -1.0, 2.2};

}  // namespace

TEST_CASE("what a force at a point asks of the joints is its Jacobian's") {
  // Planted defect, seen to fail: a force's column in the place of the next axis'.
  const Mechanism arm = arm_of_five();
  const diagnosis::RigidColumns rigid(arm, SINEW_SOURCE_DIR "/runtime");
  reference::RandomNumbers random(5);
  for (std::size_t link = 0; link < arm.bodies.size(); ++link) {
    Push push;
    push.link = link;
    for (Index i = 0; i < 3; ++i) push.point(i) = random.uniform(-0.2, 0.2);
    diagnosis::Recording log;
    log.q = MatrixXd::NullaryExpr(4, kArmJoints, [&] { return random.uniform(-1.0, 1.0); });
    log.qd = log.qdd = MatrixXd::Zero(4, kArmJoints);
    const MatrixXd columns = rigid.force_columns(arm.bodies[link].name, push.point, log);
    const reference::NewtonEuler<double> numerics(with_point(arm, push));
    for (Index k = 0; k < 4; ++k) {
      const MatrixXd jacobian = numerics.tip_jacobian(log.q.row(k).transpose());
      for (Index axis = 0; axis < 3; ++axis)
        CHECK((columns.row(k).segment(axis * kArmJoints, kArmJoints) + jacobian.row(axis)).norm() <
              1e-12);
    }
  }
}

TEST_CASE("a push that no log has is told where it acts and how strong, and spoils nothing else",
          "[slow][thorough]") {
  // Planted defects, each seen to fail: a search that does not leave the disturbed stretches out
  // (leave_out); links that are not asked (places_of); no start from the model's own values beside
  // what the pushes have made of a joint (other_starts in slot_search.cpp).
  const Mechanism arm = arm_of_five();
  const ArmFriction friction{0.6, 0.4};
  ArmLog train = draw_log(arm, 1, friction, 0.004, 20.0);
  const Findings free = diagnosed(arm, csv(train), csv(draw_log(arm, 2, friction)));
  for (const double from : {3.1, 8.4, 14.2})
    apply(arm, {4, at_hand, aside, from, from + 0.3}, train);
  const Findings found = diagnosed(arm, csv(train), csv(draw_log(arm, 2, friction)));
  INFO(found.headline);
  const NamedCause* force = unlogged_force(found);
  REQUIRE(force);
  CHECK(force->members.front().place == "link l5");
  int pushes = 0;
  for (const auto& peak : force->parameters) {
    if (peak.log.find("train.csv") == std::string::npos) continue;
    ++pushes;
    CHECK(peak.value == Approx(aside.norm()).epsilon(0.3));
  }
  CHECK(pushes == 3);
  CHECK(!unlogged_force(free));
  CHECK(found.extension.adopted);
  CHECK(found.verdict.causes.size() == free.verdict.causes.size() + 1);
  for (const NamedCause& cause : free.verdict.causes)
    CHECK(std::any_of(
        found.verdict.causes.begin(), found.verdict.causes.end(), [&](const NamedCause& other) {
          return other.members.front().name == cause.members.front().name &&
                 other.members.front().place == cause.members.front().place &&
                 std::abs(other.parameters.front().value - cause.parameters.front().value) <
                     0.02 * std::abs(cause.parameters.front().value);
        }));
}

TEST_CASE("what comes back at one place of a joint is no push", "[slow][thorough]") {
  // A ridge in the second joint's way. Planted defect, seen to fail: told_by_state() always 0.
  const Mechanism arm = arm_of_five();
  const auto log = [&](std::uint64_t seed) {
    ArmLog ridge = draw_log(arm, seed, {}, 0.004, 20.0);
    const double middle = ridge.q.col(1).mean();
    ridge.tau.col(1).array() += 6.0 * (-((ridge.q.col(1).array() - middle) / 0.02).square()).exp();
    return csv(ridge);
  };
  const Findings found = diagnosed(arm, log(1), log(2));
  INFO(found.headline);
  CHECK(!unlogged_force(found));
}

// SPDX-License-Identifier: GPL-3.0-or-later
// A joint whose position is read with play: what the model makes of that at other joints.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/identification/subjects/arm_subject.h"

namespace {

using namespace sinew;
using namespace sinew::test;
using diagnosis::Candidate;
using diagnosis::DrivenSubject;
using diagnosis::Recording;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kHalfPlay = 4e-4;  // rad
constexpr int kLoose = 1, kCarrying = 0, kCarried = 2;

/// As encoders of 22 bits read it: finer than what their steps would hide of the acceleration.
ArmLog read_finely(ArmLog log) {
  const double step = 2.0 * std::numbers::pi / (1 << 22);
  log.q = step * (log.q / step).array().round().matrix();
  return log;
}

ArmLog read_with_play(ArmLog log) {
  auto q = log.q.col(kLoose);
  for (Index k = 1; k < q.size(); ++k)
    q(k) = std::clamp(q(k - 1), q(k) - kHalfPlay, q(k) + kHalfPlay);
  return log;
}

VectorXd effort_at(const DrivenSubject& subject, int joint) {
  const Recording& log = subject.problem().training.front();
  return subject.effort()(log, log.q, log.qd, log.qdd).col(joint);
}

}  // namespace

// Seen red with columns at the joint itself alone, as if the joints carried nothing of each other.
TEST_CASE("play of a joint's sensor shows at the joints that it carries and that carry it") {
  const Mechanism arm = arm_of_five();
  const ArmLog log = draw_log(arm, 1, {0.3, 0.2}, 0.001);
  const DrivenSubject real = prepared_arm(arm, read_finely(log));
  const DrivenSubject loose = prepared_arm(arm, read_finely(read_with_play(log)));
  const std::vector<Candidate>& library = loose.problem().library;
  const auto play = std::find_if(library.begin(), library.end(), [](const Candidate& c) {
    return c.name == "hysteresis of the position sensor" && c.place == "joint j2";
  });
  REQUIRE(play != library.end());
  for (const int joint : {kCarrying, kCarried}) {
    CAPTURE(joint);
    REQUIRE(acts_on(*play, joint));
    const VectorXd missed = effort_at(real, joint) - effort_at(loose, joint);
    const VectorXd told = kHalfPlay * play->columns(loose.problem().training.front(), joint,
                                                    VectorXd::Constant(1, kHalfPlay));
    REQUIRE(missed.norm() > 0.0);
    // What a position's filter makes of so short a rest is not told: a third.
    CHECK((missed - told).squaredNorm() < 0.5 * missed.squaredNorm());
  }
}

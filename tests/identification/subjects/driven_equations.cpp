// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/driven_equations.h"

#include <catch2/catch.hpp>

#include "tests/identification/subjects/arm_logs.h"
#include "tests/identification/subjects/judged_arm.h"

namespace {

using namespace sinew;
using namespace sinew::test;
using diagnosis::EffortParts;

void check_same(const Eigen::MatrixXd& made, const Eigen::MatrixXd& anew) {
  REQUIRE(made.rows() == anew.rows());
  REQUIRE(made.cols() == anew.cols());
  CHECK((made - anew).norm() <= 1e-10 * anew.norm());
}

}  // namespace

// Seen red with all of a log's stretches counted, whatever moves: 70 of at most 8.
TEST_CASE("an effort tells as much as there is time in which its joint moves") {
  const Mechanism arm = arm_of_five();
  JudgedArm judged(arm);
  diagnosis::Recording r = judged.slowly(draw_log(arm, 1, {}));
  const Eigen::Index n = r.q.rows(), moving = n / 10, last = kArmJoints - 1;
  r.q.col(last).tail(n - moving).setConstant(r.q(moving, last));
  r.qd.col(last).tail(n - moving).setZero();
  r.qdd.col(last).tail(n - moving).setZero();
  std::vector<EffortParts> parts = judged.equations().parts_of(r);
  for (EffortParts& p : parts) p.measured = p.said;
  const std::vector<double> each = judged.equations().evidence_each(parts);
  const double most = diagnosis::evidence_of_share(0.0);
  CHECK(each.back() < 0.12 * most);
  for (std::size_t i = 0; i + 1 < each.size(); ++i) CHECK(each[i] > 0.5 * most);
}

// Seen red with the links' columns left as they are, and with all of them times the pace squared.
TEST_CASE("what a log's motion asks at another pace is told from what it asks at its own") {
  const Mechanism arm = arm_of_five();
  JudgedArm judged(arm);
  const diagnosis::Recording own = judged.slowly(draw_log(arm, 1, {0.3, 0.2}));
  REQUIRE(own.q.rows() > 0);
  const auto motion = judged.equations().logged(own);
  diagnosis::Recording slower = own;
  slower.step *= 1.7;
  slower.time *= 1.7;
  slower.qd /= 1.7;
  slower.qdd /= 1.7 * 1.7;
  for (const diagnosis::Recording& recording : {own, slower}) {
    CAPTURE(recording.step);
    const std::vector<EffortParts> made = judged.equations().parts_of(recording, *motion),
                                   anew = judged.equations().parts_of(recording);
    REQUIRE(made.size() == anew.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
      CAPTURE(i);
      CHECK(anew[i].links.norm() > 0.0);
      check_same(made[i].links, anew[i].links);
      check_same(made[i].drive, anew[i].drive);
      check_same(made[i].said, anew[i].said);
    }
  }
}

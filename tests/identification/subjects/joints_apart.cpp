// SPDX-License-Identifier: GPL-3.0-or-later
// An arm's joints stay apart in the search.
#include <catch2/catch.hpp>
#include <cstddef>
#include <numbers>

#include "tests/identification/subjects/arm_subject.h"

using namespace sinew;

// Seen red with columns at the joints that feel it: the products of every joint's columns with
// every other's were kept, which took seven joints 91 s for 54. A coefficient at each of them let
// an arm's missing mass leave a push (the gate link_mass 71).
TEST_CASE("what is fitted in any case acts at its own joint") {
  const Mechanism arm = test::arm_of_five();
  const diagnosis::DrivenSubject subject =
      test::prepared_arm(arm, test::with_encoder_steps(test::draw_log(arm, 5, {0.5, 0.2}, 0.001)));
  std::size_t of_steps = 0;
  for (const diagnosis::Candidate& c : subject.problem().library) {
    if (!c.nuisance) continue;
    INFO(c.name << " " << c.place);
    CHECK(c.channels.size() == 1);
    of_steps += c.name == "quantisation of the position sensor" ? 1 : 0;
  }
  CHECK(of_steps == static_cast<std::size_t>(test::kArmJoints));
}

TEST_CASE("steps that any good drive has, or a log's last digits, are no cause") {
  // Planted: with a limit by the range that the log moves in (1 in 25,000), as it was, those of 17
  // bits are told; without the digits those of four decimals are.
  const Mechanism arm = test::arm_of_five();
  const auto told = [&](double step) {
    const diagnosis::DrivenSubject subject = test::prepared_arm(
        arm, test::with_encoder_steps(test::draw_log(arm, 5, {0.5, 0.2}, 0.001), step));
    int count = 0;
    for (const diagnosis::Candidate& c : subject.problem().library)
      count += c.name == "quantisation of the position sensor" && !c.nuisance ? 1 : 0;
    return count;
  };
  CHECK(told(std::numbers::pi / (1 << 16)) == 0);
  CHECK(told(1e-4) == 0);
  CHECK(told(std::numbers::pi / (1 << 14)) == test::kArmJoints);
}

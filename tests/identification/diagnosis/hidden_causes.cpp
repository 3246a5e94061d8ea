// SPDX-License-Identifier: GPL-3.0-or-later
// Effects hidden in simulated drives. A few in every run; study_rates.cpp counts many.
#include <catch2/catch.hpp>

#include "tests/identification/diagnosis/drive_diagnosis.h"

using namespace sinew::test;

TEST_CASE("an effect as large as the noise is named, and nothing else", "[slow]") {
  for (const std::string name : {"viscous asymmetry", "ripple, input order 2", "spring"}) {
    INFO(name);
    const Verdict verdict = diagnose_drive(simulate_drive({name}, {1.0}, 30.0, 41), 1).verdict;
    CHECK(first_names(verdict) == std::set<std::string>{name});
    CHECK_FALSE(verdict.unexplained.none_of_the_known);
    CHECK(verdict.causes.front().confidence > 0.6);
    CHECK(verdict.relative_error_after < verdict.relative_error_before);
  }
}

TEST_CASE("where nothing is hidden nothing is named", "[slow]") {
  for (const unsigned seed : {301u, 302u, 303u, 304u}) {
    const Verdict verdict = diagnose_drive(simulate_drive({}, {}, 30.0, seed), seed).verdict;
    CHECK(verdict.nothing_beyond_noise());
    CHECK(verdict.ruled_out.size() > 20);
  }
}

TEST_CASE("an effect outside the library gets no name, but what it depends on") {
  const Verdict verdict =
      diagnose_drive(simulate_drive({"bump in position"}, {1.0}, 30.0, 77), 2).verdict;
  CHECK(verdict.unexplained.none_of_the_known);
  REQUIRE_FALSE(verdict.unexplained.depends_on.empty());
  CHECK(verdict.unexplained.depends_on.front().on.find("position") != std::string::npos);
}

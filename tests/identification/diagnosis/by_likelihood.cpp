// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated drives by the one likelihood.
#include <catch2/catch.hpp>

#include "tests/identification/diagnosis/drive_diagnosis.h"

using namespace sinew::test;

TEST_CASE("by the likelihood, too, an effect as large as the noise is named and nothing else") {
  for (const std::string name : {"viscous asymmetry", "spring"}) {
    INFO(name);
    const Verdict verdict =
        diagnose_drive_by_likelihood(simulate_drive({name}, {1.0}, 30.0, 41), 1).verdict;
    CHECK(first_names(verdict) == std::set<std::string>{name});
  }
}

TEST_CASE("by the likelihood, too, nothing is named where nothing is hidden") {
  for (const unsigned seed : {301u, 302u})
    CHECK(diagnose_drive_by_likelihood(simulate_drive({}, {}, 30.0, seed), seed)
              .verdict.causes.empty());
}

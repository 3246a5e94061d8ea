// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "identification/regression/candidate.h"

using namespace sinew::diagnosis;

TEST_CASE("errors are counted together where targets are made of the same forces") {
  // Two joints under the same tendons, and a motor. Planted defect: all channels in one group hides
  // a joint's cause behind the motor's noise (blind: sealed trials of every kind, finger).
  Problem problem;
  problem.channels = 3;
  CHECK(noise_group(problem, 1) == std::vector<int>{1});
  problem.noise_groups = {0, 0, 2};
  CHECK(noise_group(problem, 0) == std::vector<int>{0, 1});
  CHECK(noise_group(problem, 1) == std::vector<int>{0, 1});
  CHECK(noise_group(problem, 2) == std::vector<int>{2});
}

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <catch2/catch.hpp>
#include <numbers>

#include "tests/symbolic/hand/emitted_call.h"
#include "wrist_catalogue.h"

namespace sinew_tests {

constexpr double degree = std::numbers::pi / 180.0;

/// Bar angles q71, q73 [rad] of a palm pose given in degrees; the pose must be reached.
inline Values bars(double flexion, double abduction) {
  Values q = call(wrist_catalogue, "bar_angles", {flexion * degree, abduction * degree});
  REQUIRE(q[2] < 1e-14);  // residual
  REQUIRE(q[3] == 0.0);   // status
  q.resize(2);
  return q;
}

}  // namespace sinew_tests

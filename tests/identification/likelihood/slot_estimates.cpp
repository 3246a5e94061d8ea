// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes between the points of a grid.
#include "identification/likelihood/slot_estimates.h"

#include <catch2/catch.hpp>

using namespace sinew::diagnosis;

TEST_CASE("a shape between two neighbours is spaced as their grid is") {
  const std::vector<NonlinearParameter> ranges{{"speed", "rad/s", 1.0, 100.0, 3, true},
                                               {"place", "rad", 0.0, 4.0, 3, false}};
  const Eigen::Vector2d first(1.0, 0.0), second(100.0, 4.0);
  const Eigen::VectorXd half = shape_between(ranges, first, second, 0.5);
  CHECK(half(0) == Approx(10.0));
  CHECK(half(1) == Approx(2.0));
  CHECK(shape_between(ranges, first, second, 0.0) == first);
  CHECK((shape_between(ranges, first, second, 1.0) - second).norm() < 1e-12);
}

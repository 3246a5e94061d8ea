// SPDX-License-Identifier: GPL-3.0-or-later
// The scale in which coefficients are about as large as each other.
#include "identification/likelihood/moments.h"

#include <catch2/catch.hpp>

using namespace sinew::diagnosis;

// A smooth curve's higher degrees pay for less than its lower ones. Seen red with scales that know
// nothing of it.
TEST_CASE("a coefficient that is expected to be small has a small scale") {
  Candidate curve;
  curve.linear.resize(2);
  curve.linear[1].share = 0.25;
  Hypotheses all;
  all.list.resize(1);
  all.list[0].source = &curve;
  all.list[0].shapes = {0};
  all.shapes.resize(1);
  ColumnSums sums;
  sums.width = {2};
  sums.gram = RegionProducts(100.0 * Eigen::MatrixXd::Identity(2, 2));
  sums.target = Eigen::Vector2d(10.0, 10.0);
  sums.energy = Eigen::MatrixXd::Constant(1, 2, 100.0);
  sums.acting = Eigen::VectorXd::Constant(2, 50.0);
  sums.measured = Eigen::VectorXd::Constant(1, 200.0);
  sums.samples = Eigen::VectorXd::Constant(1, 50.0);
  const Moments m = moments_of(sums, all);
  REQUIRE(m.scale.size() == 2);
  CHECK(m.scale(1) == Approx(0.25 * m.scale(0)));
  CHECK(m.target(1) == Approx(0.25 * m.target(0)));
}

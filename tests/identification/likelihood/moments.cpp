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

// A payload's mass moves one joint, its moments two. Seen red with each column's region its own:
// a slot of the second joint was compared with another column's products (odds of e^3358 where the
// best fit takes 61).
TEST_CASE("all columns of a hypothesis have one region") {
  Candidate body, level;
  body.linear.resize(2);
  level.linear.resize(1);
  Hypotheses all;
  all.list.resize(2);
  all.list[0].source = &body;
  all.list[0].shapes = {0};
  all.list[1].source = &level;
  all.list[1].shapes = {1};
  all.shapes.resize(2);
  all.shapes[1].hypothesis = 1;
  ColumnSums sums;
  sums.width = {2, 1};
  sums.gram = RegionProducts(100.0 * Eigen::MatrixXd::Identity(3, 3));
  sums.target = Eigen::Vector3d(10.0, 10.0, 10.0);
  sums.energy.resize(2, 3);
  sums.energy << 100.0, 50.0, 0.0, 0.0, 50.0, 100.0;
  sums.acting = Eigen::VectorXd::Constant(3, 50.0);
  sums.measured = Eigen::VectorXd::Constant(2, 200.0);
  sums.samples = Eigen::VectorXd::Constant(2, 50.0);
  const Moments m = moments_of(sums, all);
  const Regions& regions = m.regions();
  CHECK(regions.count() == 2);
  for (const Eigen::Index column : {0, 1}) CHECK(regions.of(column) == Regions::kEverywhere);
  CHECK(regions.of(Eigen::Index{2}) == 1);
}

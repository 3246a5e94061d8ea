// SPDX-License-Identifier: GPL-3.0-or-later
// Motions that are proposed stay within what the logs have shown the drive to do.
#include "identification/diagnosis/planned_motion.h"

#include <catch2/catch.hpp>
#include <set>

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::VectorXd;

VectorXd slope(const VectorXd& x, double step) {
  return (x.tail(x.size() - 1) - x.head(x.size() - 1)) / step;
}

constexpr double kStep = 1e-3;

void check_within(const MotionRange& range, const VectorXd& q) {
  const VectorXd speed = slope(q, kStep), acceleration = slope(speed, kStep);
  CHECK(q.minCoeff() >= range.low - 1e-12);
  CHECK(q.maxCoeff() <= range.high + 1e-12);
  CHECK(speed.cwiseAbs().maxCoeff() <= 1.001 * range.speed);
  CHECK(acceleration.cwiseAbs().maxCoeff() <= 1.01 * range.acceleration);
  // Nothing that a controller would have to jump to or from.
  CHECK(std::abs(speed(0)) < 1e-3 * range.speed);
  CHECK(std::abs(speed(speed.size() - 1)) < 1e-2 * range.speed);
}

}  // namespace

TEST_CASE("planned motions are no wider, faster or more violent than the logs") {
  // Planted defect: with strokes' ramps a third shorter the acceleration is exceeded.
  const std::vector<MotionRange> ranges{{-1.0, 2.0, 4.0, 30.0, 0.0},     // roomy
                                        {0.10, 0.11, 0.5, 20.0, 3.0},    // narrow, under a load
                                        {-300.0, 300.0, 3.0, 5.0, 0.0},  // has turned on and on
                                        {-0.5, 0.5, 0.05, 1.0, -2.0}};   // slow
  for (const MotionRange& range : ranges) {
    const auto motions = planned_motions({range}, 0, kStep);
    CHECK(motions.size() == (range.load != 0.0 ? 8 : 7));
    std::set<std::string> names;
    for (const PlannedMotion& motion : motions) {
      INFO(motion.name << ", " << range.low << " to " << range.high);
      names.insert(motion.name);
      REQUIRE(motion.position.cols() == 1);
      check_within(range, motion.position.col(0));
      CHECK(motion.load.size() == (range.load != 0.0 ? motion.position.rows() : 0));
      const double seconds = kStep * static_cast<double>(motion.position.rows());
      CHECK(seconds > 2.0);
      CHECK(seconds < 180.0);
      if (range.load == 0.0) continue;
      const VectorXd share = motion.load / range.load;
      CHECK(share.minCoeff() >= 0.0);
      CHECK(share.maxCoeff() <= 1.0);
    }
    CHECK(names.size() == motions.size());
  }
}

TEST_CASE("a planned motion of one joint lets the others rest, the last but one moves all") {
  const std::vector<MotionRange> joints{
      {-1.0, 1.0, 2.0, 20.0, 0.0}, {0.0, 3.0, 1.0, 8.0, 0.0}, {-0.2, 0.1, 0.4, 3.0, 0.0}};
  const auto motions = planned_motions(joints, 1, kStep);
  REQUIRE(motions.size() == 8);
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const bool all = m == 6;
    INFO(motions[m].name);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const VectorXd q = motions[m].position.col(static_cast<Index>(j));
      if (all || j == 1)
        check_within(joints[j], q);
      else
        CHECK(q.maxCoeff() - q.minCoeff() == 0.0);
      if (all) CHECK(q.maxCoeff() - q.minCoeff() > 0.2 * (joints[j].high - joints[j].low));
    }
  }
}

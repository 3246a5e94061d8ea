// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of logs against the moments of the same logs together.
#include "identification/likelihood/log_sums.h"

#include <catch2/catch.hpp>

#include "identification/likelihood/found_slots.h"
#include "identification/likelihood/moments.h"
#include "tests/identification/likelihood/drive_stretches.h"

namespace {

using namespace sinew::test;

/// Largest difference as a share of the diagonal's.
double difference(const Moments& a, const Moments& b) {
  const Eigen::MatrixXd first = a.gram.dense();
  const Eigen::VectorXd size = first.diagonal().cwiseSqrt().cwiseMax(1e-300);
  const Eigen::MatrixXd gram = size.cwiseInverse().asDiagonal() * (first - b.gram.dense()) *
                               size.cwiseInverse().asDiagonal();
  return std::max(
      gram.cwiseAbs().maxCoeff(),
      (a.target - b.target).cwiseQuotient(size).cwiseAbs().maxCoeff() / std::sqrt(a.deviance));
}

/// Of one log of the problem alone, with the weights that the log has among all.
ColumnSums sums_of_one(const Design& design, const Hypotheses& all, const Weights& weights,
                       int recording) {
  Weights own = weights;
  for (std::size_t s = 0; s < own.size(); ++s)
    if (design.segments()[s].recording != recording) own[s].resize(0);
  return column_sums(design, all, own);
}

}  // namespace

// The last check plants the defect: a log that counts twice.
TEST_CASE("under the same whitening the logs' sums are the moments of the logs together") {
  const DriveStretches drive = drive_stretches({"viscous asymmetry"}, {1.0}, 3, 6.0, 5);
  const Problem problem = drive.problem({0, 1, 2});
  const Design design(problem, drive.settings);
  const Hypotheses all = make_hypotheses(design, fitted_baseline(design));
  const Whitening whitening =
      whitening_of(design, all, immaterial_variance(design, drive.settings, all.parts.base));
  const Weights& weights = whitening.training;
  const Moments together = moments_of(design, all, whitening);
  ColumnSums sums = sums_of_one(design, all, weights, 0);
  for (const int log : {1, 2}) sums.add(sums_of_one(design, all, weights, log));
  const Moments added = moments_of(sums, all);
  REQUIRE(added.gram.size() == together.gram.size());
  CHECK((added.scale - together.scale).cwiseQuotient(together.scale).cwiseAbs().maxCoeff() < 1e-12);
  CHECK(difference(together, added) < 1e-10);
  CHECK(added.deviance == Approx(together.deviance).epsilon(1e-10));
  CHECK(added.rows == together.rows);
  sums.add(sums_of_one(design, all, weights, 2));
  CHECK(difference(together, moments_of(sums, all)) > 1e-3);
}

TEST_CASE("a log's sums have the columns of the reference logs, whatever the log's own range") {
  const DriveStretches drive = drive_stretches({}, {}, 3, 6.0, 6);
  const ReferenceColumns reference(drive.problem({0}), drive.settings);
  LogSums sums = reference.sums({drive.logs[1]});
  const LogSums other = reference.sums({drive.logs[2]});
  CHECK(sums.columns.width == other.columns.width);
  CHECK(sums.columns.gram.dense() != other.columns.gram.dense());
  const double rows = sums.columns.rows;
  sums.add(other);
  CHECK(sums.columns.rows == rows + other.columns.rows);
  // Other reference logs spread the grids otherwise.
  CHECK(reference.hash() == ReferenceColumns(drive.problem({0}), drive.settings).hash());
  CHECK(reference.hash() != ReferenceColumns(drive.problem({1}), drive.settings).hash());
}

TEST_CASE("channels that share their noise are refused, not summed") {
  const DriveStretches drive = drive_stretches({}, {}, 1, 6.0, 7);
  Problem problem = drive.problem({0});
  problem.noise_groups = {0};
  CHECK_THROWS_WITH(ReferenceColumns(problem, drive.settings), Catch::Contains("share the noise"));
}

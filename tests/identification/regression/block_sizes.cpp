// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which products are summed is not the machine's.
#include "identification/regression/block_sizes.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace sinew;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

MatrixXd waves(Index rows, Index cols) {
  return MatrixXd::NullaryExpr(rows, cols, [rows](Index i, Index j) {
    return std::sin(0.7 * static_cast<double>(i) * static_cast<double>(j + 1) +
                    0.1 * static_cast<double>(rows));
  });
}

/// A matrix of sums over many samples.
MatrixXd gram() {
  const MatrixXd x = waves(3000, 60);
  return x.transpose() * x;
}

}  // namespace

TEST_CASE("sums are the same whatever caches a processor has") {
  // Seen to fail without fix_block_sizes() after the other caches. On two processors a finger's
  // push was told on one and not on the other.
  const MatrixXd fixed = gram();
  Eigen::setCpuCacheSizes(8 * 1024, 64 * 1024, 128 * 1024);
  const MatrixXd other = gram();
  diagnosis::fix_block_sizes();
  CHECK((other - fixed).cwiseAbs().maxCoeff() > 0.0);
  CHECK(gram() == fixed);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/pseudo_inverse.h"

#include <Eigen/QR>
#include <catch2/catch.hpp>
#include <cmath>

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr Index kSize = 12;

MatrixXd directions() {
  MatrixXd x(kSize, kSize);
  for (Index r = 0; r < kSize; ++r)
    for (Index c = 0; c < kSize; ++c)
      x(r, c) = std::sin(static_cast<double>(1 + 3 * r + 7 * c * c));
  const Eigen::HouseholderQR<MatrixXd> factor(x);
  return factor.householderQ() * MatrixXd::Identity(kSize, kSize);
}

MatrixXd with_smallest(double smallest) {
  VectorXd values = VectorXd::LinSpaced(kSize, 1.0, 2.0);
  values(0) = smallest;
  const MatrixXd v = directions();
  return v * values.asDiagonal() * v.transpose();
}

}  // namespace

TEST_CASE("what is nearly dependent is inverted, and left out where it is dependent") {
  // Planted defect, seen to fail: the bound on the eigenvalues left out, so that what is dependent
  // is inverted wherever rounding lets it.
  for (const double smallest : {1.0, 1e-4, 1e-7}) {
    const MatrixXd gram = with_smallest(smallest);
    CHECK((gram * scaled_pseudo_inverse(gram) - MatrixXd::Identity(kSize, kSize)).norm() < 1e-6);
  }
  for (const double smallest : {1e-11, 1e-12, 0.0})
    CHECK(scaled_pseudo_inverse(with_smallest(smallest)).norm() < 10.0);
  // A column that is nothing and one that says what another one does: each of the two takes half.
  MatrixXd gram = MatrixXd::Zero(kSize + 2, kSize + 2);
  gram.topLeftCorner(kSize, kSize) = with_smallest(0.5);
  gram.row(kSize) = gram.row(3);
  gram.col(kSize) = gram.col(3);
  const MatrixXd inverse = scaled_pseudo_inverse(gram);
  CHECK((gram * inverse * gram - gram).norm() < 1e-12);
  CHECK((inverse.col(kSize) - inverse.col(3)).norm() < 1e-12);
  CHECK(inverse.col(kSize + 1).norm() == 0.0);
}

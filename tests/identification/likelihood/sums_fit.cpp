// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares from products against the rows that they were made of.
#include "identification/likelihood/sums_fit.h"

#include <Eigen/QR>
#include <catch2/catch.hpp>

using namespace sinew::diagnosis;

TEST_CASE("products of columns tell what their rows would") {
  std::srand(3);
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(40, 5);
  const Eigen::VectorXd y = Eigen::VectorXd::Random(40);
  ColumnSums sums;
  sums.gram = RegionProducts(x.transpose() * x);
  sums.target = x.transpose() * y;
  sums.deviance = y.squaredNorm();
  const std::vector<Eigen::Index> some{4, 1, 2};
  const Eigen::MatrixXd a = x(Eigen::all, some);
  const Eigen::VectorXd b = fitted_to(sums, some);
  CHECK((b - a.householderQr().solve(y)).norm() < 1e-10);
  CHECK(error_left(sums, some, b) == Approx((y - a * b).squaredNorm()));
  const Eigen::Vector3d other(1.0, -2.0, 0.5);
  CHECK(error_left(sums, some, other) == Approx((y - a * other).squaredNorm()));
}

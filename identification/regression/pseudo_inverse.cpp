// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/pseudo_inverse.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd squared(const MatrixXd& root) {
  MatrixXd product = MatrixXd::Zero(root.rows(), root.rows());
  product.selfadjointView<Eigen::Lower>().rankUpdate(root);
  product.triangularView<Eigen::StrictlyUpper>() = product.transpose();
  return product;
}

/// No eigenvalue is smaller than 1 / the inverse's norm nor larger than the matrix' own, so that
/// none counts as zero; twice for what rounding makes of the inverse.
bool is_regular(const MatrixXd& gram, const MatrixXd& inverse, double tolerance) {
  return 2.0 * tolerance * gram.norm() * inverse.norm() < 1.0;
}

/// Pivoted Cholesky factor of a matrix of unit diagonal, as far as there is more than rounding.
MatrixXd pivoted_factor(const MatrixXd& unit) {
  constexpr double kRounding = 1e-13;
  MatrixXd half(unit.rows(), unit.cols());
  VectorXd left = unit.diagonal();
  Index rank = 0, pivot = 0;
  for (; rank < unit.cols() && left.maxCoeff(&pivot) > kRounding; ++rank) {
    const double root = std::sqrt(left(pivot));
    half.col(rank) = unit.col(pivot);
    if (rank > 0) half.col(rank) -= half.leftCols(rank) * half.row(pivot).head(rank).transpose();
    half.col(rank) /= root;
    left -= half.col(rank).cwiseAbs2();
    left(pivot) = 0.0;
  }
  return half.leftCols(rank);
}

/// A root of the pseudo-inverse of a matrix of unit diagonal, without its eigenvectors. None: some
/// eigenvalue is so small that they have to tell whether it counts as zero.
std::optional<MatrixXd> root_by_factor(const MatrixXd& unit, double tolerance) {
  const Eigen::LLT<MatrixXd> factor(unit);
  if (factor.info() == Eigen::Success) {
    MatrixXd half = factor.matrixL().solve(MatrixXd::Identity(unit.rows(), unit.cols()));
    half.transposeInPlace();
    if (is_regular(unit, squared(half), tolerance)) return half;
  }
  // Columns of a body that its joint does not move, or moves as others, depend on those exactly.
  const MatrixXd half = pivoted_factor(unit);
  const MatrixXd own = half.transpose() * half;
  const Eigen::LLT<MatrixXd> small(own);
  if (half.cols() == 0 || small.info() != Eigen::Success) return std::nullopt;
  const MatrixXd inverse = small.solve(MatrixXd::Identity(own.rows(), own.cols()));
  if (!is_regular(own, inverse, tolerance)) return std::nullopt;
  return MatrixXd(half * inverse);
}

MatrixXd root_by_eigenvectors(const MatrixXd& unit, double tolerance) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(unit);
  const double limit = tolerance * std::max(eigen.eigenvalues().maxCoeff(), 1e-300);
  const VectorXd& values = eigen.eigenvalues();  // ascending
  const Index zeros = (values.array() <= limit).count();
  const Index rank = values.size() - zeros;
  return eigen.eigenvectors().rightCols(rank) *
         values.tail(rank).cwiseSqrt().cwiseInverse().asDiagonal();
}

}  // namespace

MatrixXd scaled_pseudo_root(const MatrixXd& gram, double tolerance) {
  if (gram.size() == 0) return gram;
  const VectorXd scale =
      gram.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / std::sqrt(d) : 0.0; });
  const MatrixXd unit = scale.asDiagonal() * gram * scale.asDiagonal();
  // The decomposition takes ten times as long and is for what is nearly dependent.
  const std::optional<MatrixXd> root = root_by_factor(unit, tolerance);
  return scale.asDiagonal() * (root ? *root : root_by_eigenvectors(unit, tolerance));
}

MatrixXd scaled_pseudo_inverse(const MatrixXd& gram, double tolerance) {
  return squared(scaled_pseudo_root(gram, tolerance));
}

}  // namespace sinew::diagnosis

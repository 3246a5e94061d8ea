// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/sums_fit.h"

#include <algorithm>

#include "identification/regression/linear_fit.h"
#include "identification/regression/pseudo_inverse.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

}  // namespace

VectorXd fitted_to(const ColumnSums& sums, const std::vector<Index>& columns) {
  return scaled_pseudo_inverse(sums.gram(columns, columns)) * VectorXd(sums.target(columns));
}

double error_left(const ColumnSums& sums, const std::vector<Index>& columns,
                  const VectorXd& coefficients) {
  return sums.deviance - 2.0 * coefficients.dot(VectorXd(sums.target(columns))) +
         coefficients.dot(sums.gram(columns, columns) * coefficients);
}

}  // namespace sinew::diagnosis

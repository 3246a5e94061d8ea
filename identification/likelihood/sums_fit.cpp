// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/sums_fit.h"

#include <algorithm>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of a matrix whose lower half is known.
MatrixXd symmetric_part(const MatrixXd& lower, const std::vector<Index>& at) {
  const auto count = static_cast<Index>(at.size());
  MatrixXd part(count, count);
  for (Index c = 0; c < count; ++c)
    for (Index r = 0; r < count; ++r) {
      const Index a = at[static_cast<std::size_t>(r)], b = at[static_cast<std::size_t>(c)];
      part(r, c) = lower(std::max(a, b), std::min(a, b));
    }
  return part;
}

}  // namespace

VectorXd fitted_to(const ColumnSums& sums, const std::vector<Index>& columns) {
  return scaled_pseudo_inverse(symmetric_part(sums.gram, columns)) * VectorXd(sums.target(columns));
}

double error_left(const ColumnSums& sums, const std::vector<Index>& columns,
                  const VectorXd& coefficients) {
  return sums.deviance - 2.0 * coefficients.dot(VectorXd(sums.target(columns))) +
         coefficients.dot(symmetric_part(sums.gram, columns) * coefficients);
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares from the products of columns alone.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/likelihood/column_sums.h"

namespace sinew::diagnosis {

/// Coefficients of some columns of the sums in their own units; the minimum-norm ones where columns
/// depend on each other.
Eigen::VectorXd fitted_to(const ColumnSums& sums, const std::vector<Eigen::Index>& columns);

/// Whitened squared error that given coefficients of some columns leave.
double error_left(const ColumnSums& sums, const std::vector<Eigen::Index>& columns,
                  const Eigen::VectorXd& coefficients);

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// Pseudo-inverses of Gram matrices whose columns may depend on each other.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// Relative eigenvalues, of the matrix scaled to a unit diagonal, below this count as zero. A limit
/// of rounding: the test of these functions holds both sides of it, 1e-7 to be inverted and 1e-11
/// to be left out.
inline constexpr double kDependent = 1e-10;

/// Symmetric pseudo-inverse after scaling to a unit diagonal; relative eigenvalues below
/// `tolerance` count as zero.
Eigen::MatrixXd scaled_pseudo_inverse(const Eigen::MatrixXd& gram, double tolerance = kDependent);

/// The same as a root: the pseudo-inverse is root root'. Rows as gram has, columns as its rank.
Eigen::MatrixXd scaled_pseudo_root(const Eigen::MatrixXd& gram, double tolerance = kDependent);

}  // namespace sinew::diagnosis

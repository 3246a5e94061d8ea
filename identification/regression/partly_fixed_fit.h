// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares of which a few columns change from one fit to the next.
#pragma once

#include <vector>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// What the columns that stay need is worked out once: their normal matrix is inverted here, and
/// every fit takes them out of those that move (Schur's complement).
class PartlyFixedFit {
 public:
  /// `moves`: of each coefficient of the stack whether its column will change.
  PartlyFixedFit(const Stack& stack, const std::vector<bool>& moves);

  /// What solve() leaves over of the stack, of which moving columns alone may have changed.
  Eigen::VectorXd residual(const Stack& stack) const;

 private:
  /// Columns of one segment, and where they stand among all that stay, or that move.
  struct Part {
    std::vector<Eigen::Index> fixed, moving;        ///< columns of the segment's matrix
    std::vector<Eigen::Index> fixed_at, moving_at;  ///< of fixed_, of moving_
  };
  struct Normal {
    Eigen::MatrixXd cross;  ///< root_' x products of the columns that stay with those that move
    Eigen::MatrixXd left;   ///< pseudo-inverse of what the others leave of those that move
  };
  Normal normal(const Stack& stack) const;
  /// The coefficients, in the stack's order, that answer a moment of its columns.
  Eigen::VectorXd step(const Normal& n, const Eigen::VectorXd& moment) const;

  std::vector<Eigen::Index> fixed_, moving_;  ///< coefficients of the stack
  std::vector<Part> parts_;                   ///< one for each segment
  Eigen::MatrixXd root_;  ///< root_ root_': pseudo-inverse of the normal matrix of those that stay
};

}  // namespace sinew::diagnosis

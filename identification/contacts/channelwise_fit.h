// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares of many terms most of which act on one channel each.
#pragma once

#include <memory>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Each channel's own columns are eliminated before those that several channels share: with the
/// friction of every joint in many forms the normal matrix is a hundred times cheaper to invert by
/// parts than as a whole.
class ChannelwiseFit {
 public:
  /// `channel`: of each segment of the stack.
  ChannelwiseFit(const Stack& stack, const std::vector<int>& channel);
  ~ChannelwiseFit();

  /// As solve() fits them, up to rounding and to what is nearly dependent.
  const Eigen::VectorXd& coefficients() const { return coefficients_; }
  /// Of what the fit says where the columns are these (one for each coefficient), for errors of
  /// variance 1 in the stack's rows.
  double variance(const Eigen::VectorXd& columns) const;

 private:
  class Inverse;
  std::unique_ptr<const Inverse> inverse_;
  Eigen::VectorXd coefficients_;
};

}  // namespace sinew::diagnosis

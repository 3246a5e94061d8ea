// SPDX-License-Identifier: GPL-3.0-or-later
// How much more probable the data are with an entry than without it.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// An entry's columns given everything else in the model: their Gram matrix, their products with
/// what is left over, and the limits of their coefficients, all in the scale of Moments.
struct ConditionalMoments {
  Eigen::MatrixXd gram;
  Eigen::VectorXd target;
  Eigen::VectorXd low, high;
};

struct BayesFactor {
  double logarithm = 0.0;  ///< averaged over the sizes
  double variance = 0.0;   ///< prior variance of the coefficients at the most probable size
};

/// Coefficients are normal with mean 0 about the model's values, cut off at their limits; their
/// standard deviation is spread evenly (in its logarithm) from kSmallestSize to kLargestSize.
BayesFactor bayes_factor_of(const ConditionalMoments& m);

/// What its logarithm is at most: that of the best fit, as near to 0 as the largest size makes it.
/// Infinite for more than two columns between limits.
double most_by_fit(const ConditionalMoments& m);

/// log P(low < x < high) of a normal x; exact far into both tails.
double log_probability_between(double low, double high, double mean, double deviation);

}  // namespace sinew::diagnosis

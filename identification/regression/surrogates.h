// SPDX-License-Identifier: GPL-3.0-or-later
// Phase-randomised surrogates of the residual, and the null distributions taken from them.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/noise_model.h"

namespace sinew::diagnosis {

/// Whitened surrogate residuals: per segment, 2 * bins x count (empty for held-out logs). Each has
/// the residual's spectrum and random phases; whatever is structured in the residual is gone.
std::vector<Eigen::MatrixXf> make_surrogates(const Design& design,
                                             const std::vector<NoiseModel>& noise, int count,
                                             unsigned seed);

/// Null distribution of one statistic: zero with some probability (a violated sign), else gamma.
class NullDistribution {
 public:
  NullDistribution() = default;
  explicit NullDistribution(const Eigen::VectorXd& samples);
  double mean() const { return mean_; }
  /// -ln P(statistic >= value), exact far into the tail.
  double surprise(double value) const;

 private:
  double positive_ = 0.0, shape_ = 0.5, scale_ = 2.0, mean_ = 0.0;
};

/// Family-wise null of the largest surprise over a library.
class FamilyNull {
 public:
  FamilyNull() = default;
  /// largest: the maximum over the library, one for each surrogate.
  explicit FamilyNull(const Eigen::VectorXd& largest);
  /// Probability that the best of the library is at least this surprising under the null.
  double p_value(double surprise) const;
  double effective_tests() const { return tests_; }

 private:
  Eigen::VectorXd sorted_;
  double tests_ = 1.0;
};

}  // namespace sinew::diagnosis

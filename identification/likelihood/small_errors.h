// SPDX-License-Identifier: GPL-3.0-or-later
// The search's moments where everything is off by a little, and laws of one make by more.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/likelihood/moments.h"

namespace sinew::diagnosis {

/// A law that was found at all places of one make at once, as it was fitted.
struct FoundLaw {
  int shape = 0;
  Eigen::VectorXd coefficients;  ///< in the parameters' units, by coefficient of the shape
};

/// Moments where every hypothesis of several shapes is off by chance by a share of the rms of what
/// was measured, and a law of one make by kFormError at each place by itself and in each form that
/// its name has: their columns are noise besides. The products are those of the whitened rows under
/// that noise.
class SmallErrors {
 public:
  /// share: standard deviation of a hypothesis' error; 0: there is none.
  SmallErrors(const Moments& m, const Hypotheses& all, double share,
              const std::vector<FoundLaw>& laws = {});

  /// Gram matrix of some columns (rows) with some others.
  Eigen::MatrixXd gram(const std::vector<Eigen::Index>& rows,
                       const std::vector<Eigen::Index>& columns) const;
  const Eigen::VectorXd& target() const { return target_; }
  /// log p(what was measured | no cause) up to what all shares have in common.
  double log_likelihood() const { return log_likelihood_; }
  const Moments& moments() const { return m_; }

 private:
  /// What errors of some hypotheses take: their rows of the Cholesky factor's inverse times their
  /// products with a region's columns. The Gram matrix less taken' taken of every region that both
  /// columns have is the one under small errors.
  struct Taken {
    int region = Regions::kEverywhere;
    Eigen::MatrixXd rows;
  };
  struct Errors;
  void take_shares(const Hypotheses& all, double share);
  void take_law(const Hypotheses& all, const FoundLaw& law);
  void take(const Errors& errors, const std::vector<std::size_t>& which, int region);
  /// Errors of standard deviation 1: products with the region's columns, with each other, and with
  /// the target.
  void take(int region, const Eigen::MatrixXd& cross, Eigen::MatrixXd inner,
            const Eigen::VectorXd& target);

  const Moments& m_;
  std::vector<Taken> taken_;
  Eigen::VectorXd target_;
  double log_likelihood_ = 0.0;
};

}  // namespace sinew::diagnosis

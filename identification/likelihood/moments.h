// SPDX-License-Identifier: GPL-3.0-or-later
// All that the search knows of the logs: products of whitened columns with each other and with what
// the model leaves over, with the model's free part projected out.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/likelihood/column_sums.h"
#include "identification/likelihood/regions.h"

namespace sinew::diagnosis {

/// Columns of length 0 are left out; each is scaled so that a coefficient of 1 has the rms of what
/// was measured in the channels where it acts (its share of that, where it is expected to be
/// smaller than its cause's first one), or so that the largest size is the standard deviation that
/// was known before any log, where that is less.
struct Moments {
  /// Of each shape its columns here: [first, first + count).
  struct Range {
    Eigen::Index first = 0, count = 0;
  };
  std::vector<Range> of_shape;
  std::vector<int> coefficient;  ///< of each column: which one of its shape's it is
  Eigen::VectorXd scale;         ///< a column's coefficient times this is in its own unit
  RegionProducts gram;
  Eigen::VectorXd target;
  double deviance = 0.0;  ///< of what the model leaves over
  double rows = 0.0;      ///< independent real rows of the logs
  /// Of the free part's coefficients, what the logs leave open: -1/2 log det of their Gram matrix.
  double log_free_volume = 0.0;

  const Regions& regions() const { return gram.regions(); }
};

Moments moments_of(const ColumnSums& sums, const Hypotheses& all);
Moments moments_of(const Design& design, const Hypotheses& all, const Whitening& whitening);

/// Moments where every hypothesis of several shapes is off by chance by a share of the rms of what
/// was measured:
/// its columns are noise besides. The products are those of the whitened rows under that noise.
class SmallErrors {
 public:
  /// share: standard deviation of a hypothesis' error; 0: there is none.
  SmallErrors(const Moments& m, const Hypotheses& all, double share);

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
  void take(const Errors& errors, const std::vector<std::size_t>& which, int region);

  const Moments& m_;
  std::vector<Taken> taken_;
  Eigen::VectorXd target_;
  double log_likelihood_ = 0.0;
};

}  // namespace sinew::diagnosis

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

}  // namespace sinew::diagnosis

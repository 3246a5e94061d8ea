// SPDX-License-Identifier: GPL-3.0-or-later
// From sums to a verdict: the search of explain(), on moments that no log is left of.
#pragma once

#include <memory>
#include <vector>

#include "identification/diagnosis/verdict.h"
#include "identification/likelihood/found_slots.h"
#include "identification/likelihood/log_sums.h"

namespace sinew::diagnosis {

/// What the sums of all training logs say.
struct ExplainedSums {
  std::unique_ptr<FoundSlots> found;
  Verdict verdict;
  /// Of every cause of the verdict its columns in ColumnSums.
  std::vector<std::vector<Eigen::Index>> columns;
  /// Share of the whitened squared error of the training logs that is left with all causes.
  double whitened_error_left = 1.0;
};

/// A shape between two points of a grid is told as the value between them that their coefficients
/// say. Gains `cross_validated` are shares of the training sums' whitened error, without an
/// interval: sums have no blocks to leave out.
ExplainedSums explain_sums(const ReferenceColumns& reference, const LogSums& training);

/// Whitened squared errors of held-out logs, log by log, from the training sums' coefficients.
class HeldOutErrors {
 public:
  HeldOutErrors(const ExplainedSums& explained, const ColumnSums& training);
  /// One held-out log.
  void add(const ColumnSums& log);
  /// Fills in what every cause and all of them gain, with the interval that resampling whole logs
  /// gives.
  void tell(unsigned seed, Verdict& verdict) const;

 private:
  struct Fit {
    std::vector<Eigen::Index> columns;
    Eigen::VectorXd coefficients;
    std::vector<double> errors;  ///< of every log
  };
  Fit with_, without_any_;
  std::vector<Fit> without_;  ///< each cause
};

}  // namespace sinew::diagnosis

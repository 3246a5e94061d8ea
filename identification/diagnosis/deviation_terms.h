// SPDX-License-Identifier: GPL-3.0-or-later
// A fitted model taken apart: what stays free, what is held at its nominal value, and the columns
// of every parameter deviation.
#pragma once

#include <memory>
#include <vector>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// The pieces. Candidates made on the way are owned here; terms point to them.
struct DeviationTerms {
  Model base;  ///< free baseline coefficients and causes; the nominal part is fixed
  std::vector<Term> deviations;  ///< one for each deviation of the problem, in its order
  std::vector<std::shared_ptr<const Candidate>> made;
  std::vector<Term> nominal;  ///< whose values at `covered` are fixed; columns are left out
  std::vector<std::vector<bool>> covered;  ///< of each of these, by linear parameter
};

/// Nonlinear parameters of the baseline keep the model's values. Throws std::invalid_argument where
/// a share points to no baseline coefficient or to one per log.
DeviationTerms take_apart(const Design& design, const Model& model);

/// What a model taken apart says of every segment, in its recording's samples: nominal parts as
/// they are, free ones with `coefficients`. Values that belong to one log are left out.
std::vector<Eigen::VectorXd> said_unfiltered(const Design& design, const DeviationTerms& parts,
                                             const Eigen::VectorXd& coefficients);

/// What a delay of what the nominal model says adds to it, per second: its time derivative.
/// channels: where it acts; empty: everywhere.
BandColumns delay_columns(const Design& design, const std::vector<int>& channels,
                          const FixedPart& nominal);

/// Prediction and its rate of all (or all covered) baseline coefficients at their nominal values.
/// covered: per term and linear parameter; empty: all.
FixedPart nominal_part(const Design& design, const Model& model,
                       const std::vector<std::vector<bool>>& covered);

}  // namespace sinew::diagnosis

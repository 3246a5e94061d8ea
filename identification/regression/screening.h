// SPDX-License-Identifier: GPL-3.0-or-later
// What each candidate of the library would explain on top of a model, against its own null.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "identification/regression/surrogates.h"

namespace sinew::diagnosis {

/// A candidate at one starting value of its nonlinear parameters. The library's columns are most of
/// what a search remembers, and single precision is a thousand times finer than what is told by
/// them.
struct Slot {
  int candidate = 0;
  Eigen::VectorXd nonlinear;
  LibraryColumns columns;  ///< of the training logs
  double in_band = 1.0;    ///< share of the raw columns' energy that the filter leaves
};

/// All slots of a library, evaluated once. Delays have no slot: their column follows the model.
class Library {
 public:
  Library(const Design& design);
  const std::vector<Slot>& slots() const { return slots_; }
  /// A few columns of every candidate, for the saturating fit of the noise model.
  std::vector<const LibraryColumns*> representatives() const;

 private:
  std::vector<Slot> slots_;
};

/// Why a candidate cannot be taken at this step.
enum class Gate {
  open,
  not_excited,  ///< inside the model's span, or zero
  out_of_band,  ///< mostly above the band: what is left of it there is not the effect
  limit_violated
};

/// One candidate on top of the model.
struct Screened {
  int candidate = 0;
  Gate gate = Gate::not_excited;
  double statistic = 0.0;   ///< drop of the whitened deviance, best starting value
  double excitation = 0.0;  ///< share of the column's energy that the model does not span
  double surprise = 0.0;    ///< -ln p of its own null
  double freedom = 1.0;     ///< mean of its null: effective number of parameters
  NullDistribution null;
  Eigen::VectorXd nonlinear;
  Eigen::VectorXd coefficients;
  double unrestricted = 0.0;  ///< the statistic without limits, to tell "wrong sign" from "absent"
};

struct Screening {
  std::vector<Screened> candidates;  ///< in the library's order
  FamilyNull family;
};

/// Which candidates take part in a screening, and in its family-wise null.
enum class Scope { nameable, everything };  ///< nameable: all but the flexible families

/// Tests the library. `surrogates` may be empty: then no null is made (statistics only). Candidates
/// outside the scope stay Gate::not_excited.
Screening screen(const Design& design, const Library& library, const Model& model,
                 const Weights& weights, const std::vector<Eigen::MatrixXf>& surrogates,
                 Scope scope = Scope::nameable);

/// Starting values of a candidate: the grid over its nonlinear parameters.
std::vector<Eigen::VectorXd> starting_values(const Candidate& candidate);

}  // namespace sinew::diagnosis

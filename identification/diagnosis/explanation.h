// SPDX-License-Identifier: GPL-3.0-or-later
// A verdict and the fitted model it stands for.
#pragma once

#include "identification/diagnosis/selection.h"
#include "identification/diagnosis/slot_form.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

struct Explanation {
  Verdict verdict;
  Selection selection;
  /// Parameters of every term of the selection's model.
  std::vector<std::vector<ParameterEstimate>> estimates;
  /// Where the problem has deviations: the model the verdict's errors and gains stand for, with the
  /// baseline at its nominal values but for the named deviations, whose terms come last.
  Selection adopted;
  /// Terms of what was found and has no name: in no model, but part of what the logs hold.
  std::vector<Term> structure;
  /// What the likelihood has found, named or not: another search of nearly the same logs begins
  /// from it.
  std::vector<SlotForm> forms;
};

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// From a verdict to the model's own entries: what goes into identified.toml.
#pragma once

#include <string>
#include <vector>

#include "identification/driven_subject.h"
#include "identification/explain.h"

namespace sinew::diagnosis {

/// One term of the final model as an entry.
struct ExtensionTerm {
  std::size_t term = 0;  ///< of the selection's model
  int cause = -1;        ///< index into the verdict's causes; -1: a re-fitted value of the baseline
  IdentifiedEffect entry;
  bool per_log = false;  ///< has coefficients that differ from log to log
  bool baseline = false;
};

/// The entries of all causes that have a term in the model, and the baseline's changed values.
std::vector<ExtensionTerm> extension_terms(const DrivenSubject& subject,
                                           const Explanation& explanation);

/// `before` with the entries added. The same effect at the same place with the same shape adds up.
Identified extended(const Identified& before, const std::vector<ExtensionTerm>& terms);

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// From a verdict to the model's own entries: what goes into identified.toml.
#pragma once

#include <string>
#include <vector>

#include "identification/diagnosis/explanation.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// A term of the final model as an entry.
struct ExtensionTerm {
  int cause = -1;  ///< index into the verdict's causes; -1: goes with others
  IdentifiedEffect entry;
  bool per_log = false;  ///< has coefficients that differ from log to log
};

struct ExtensionTerms {
  std::vector<ExtensionTerm> terms;
  std::vector<std::string> changed;  ///< a sentence for what is not as it was fitted
};

/// The entries of all causes that have a term in the model, and the direction of friction that
/// they were found with. Links stay bodies (physical_links.h). `fitted`: the explanation's own fit,
/// or one with fewer causes (adopted_fit.h).
ExtensionTerms extension_terms(const DrivenSubject& subject, const Design& design,
                               const Explanation& explanation, const Selection& fitted);

/// `before` with the entries added. The same effect at the same place with the same shape adds up.
Identified extended(const Identified& before, const std::vector<ExtensionTerm>& terms);

}  // namespace sinew::diagnosis

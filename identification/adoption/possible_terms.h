// SPDX-License-Identifier: GPL-3.0-or-later
// Which terms a model can take and still be one that there can be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/adoption/extend.h"
#include "symbolic/extension/observation.h"

namespace sinew::diagnosis {

/// Why a model with these entries could not be: identified.toml would be refused where it is read,
/// a link would be no body, or the mass matrix not positive definite over the joints' ranges.
std::optional<std::string> why_impossible(const DrivenSubject& subject,
                                          const Identified& identified);

/// The same of a rig, whose entries change no mechanism.
std::optional<std::string> why_impossible(const Observation& observation,
                                          const Identified& identified);

struct PossibleTerms {
  std::vector<ExtensionTerm> terms;
  std::vector<std::string> refused;  ///< a sentence for each term left out: which, and why
};

/// One term after the other as far as the model stays possible, those of links first: what they
/// weigh decides what a drive's inertia may be.
PossibleTerms possible_terms(const DrivenSubject& subject, std::vector<ExtensionTerm> terms);

}  // namespace sinew::diagnosis

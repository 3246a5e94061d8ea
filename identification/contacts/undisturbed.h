// SPDX-License-Identifier: GPL-3.0-or-later
// The search again, without what an unlogged force does to the logs.
#pragma once

#include <functional>
#include <optional>

#include "identification/diagnosis/explanation.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// An explanation of a subject's logs, from the forms of another one on.
using Search = std::function<Explanation(const DrivenSubject&, const std::vector<SlotForm>&)>;
struct Searches {
  Search rough, full;
};

/// Where logs are disturbed now and then, a search is done again without those stretches. If a
/// force explains them, the subject leaves them out from then on, the explanation is the second
/// one, and the force is returned as a cause.
std::optional<NamedCause> find_undisturbed(const Searches& searches, const Settings& settings,
                                           DrivenSubject& subject, Explanation& explanation);

}  // namespace sinew::diagnosis

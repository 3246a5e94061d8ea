// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated mass properties as those of the nearest bodies that there can be.
#pragma once

#include <string>
#include <vector>

#include "identification/diagnosis/explanation.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// All terms' estimates, of estimates(). A regression knows no bodies: where a payload or a link
/// that it gives cannot be one, its parameters become those of the body (a Cholesky factor with
/// logarithms on its diagonal) that raises the misfit least, and what was fitted beside it follows.
/// Returns a sentence where that is not what the logs say.
std::vector<std::string> make_links_physical(
    const DrivenSubject& subject, const Design& design, const Selection& selection,
    std::vector<std::vector<ParameterEstimate>>& estimates);

}  // namespace sinew::diagnosis

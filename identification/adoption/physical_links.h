// SPDX-License-Identifier: GPL-3.0-or-later
// Estimated mass properties as those of the nearest bodies that there can be.
#pragma once

#include <string>
#include <vector>

#include "identification/diagnosis/explanation.h"
#include "identification/subjects/driven_subject.h"

namespace sinew::diagnosis {

/// What the drawing of a link is off by beside a payload that the link carries.
struct DrawingError {
  std::size_t term = 0;                      ///< the payload's
  std::string link;                          ///< its place
  std::vector<ParameterEstimate> estimates;  ///< ten
};

struct PhysicalLinks {
  std::vector<DrawingError> drawings;
  std::vector<std::string> changed;  ///< a sentence where bodies are not what the logs say
};

/// All terms' estimates, of estimates(). A regression knows no bodies: where a payload or a link
/// that it gives cannot be one, its parameters become those of the body (a Cholesky factor with
/// logarithms on its diagonal) that raises the misfit least, and what was fitted beside it follows.
/// Where a payload cannot be one by more than chance, what is told of it has an error of the link's
/// drawing in it, as large as the link's prior lets it be.
PhysicalLinks make_links_physical(const DrivenSubject& subject, const Design& design,
                                  const Selection& selection,
                                  std::vector<std::vector<ParameterEstimate>>& estimates);

}  // namespace sinew::diagnosis

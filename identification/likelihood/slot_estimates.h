// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of slots from the moments alone.
#pragma once

#include <vector>

#include "identification/diagnosis/verdict.h"
#include "identification/likelihood/found_slots.h"

namespace sinew::diagnosis {

/// Of every slot of `slots` its parameters with standard errors, all fitted together with small
/// errors in everything as the search found them; linear ones first, then its shape. A slot of two
/// neighbouring shapes has the sum of their coefficients and a shape between them; the standard
/// error of a grid's point is its distance to the next ones / sqrt(12).
std::vector<std::vector<ParameterEstimate>> slot_estimates(const FoundSlots& found,
                                                           const std::vector<std::size_t>& slots);

/// The shape between two neighbouring ones that takes `share` (0..1) of the second.
Eigen::VectorXd shape_between(const std::vector<NonlinearParameter>& ranges,
                              const Eigen::VectorXd& first, const Eigen::VectorXd& second,
                              double share);

}  // namespace sinew::diagnosis

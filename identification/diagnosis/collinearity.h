// SPDX-License-Identifier: GPL-3.0-or-later
// No term has exactly the form of what it names, and what another form leaves over invites others:
// a cause that is small beside a large one, and large where that one is missing, is collinear with
// it.
#pragma once

#include <optional>

#include "identification/regression/cross_validation.h"

namespace sinew::diagnosis {

/// Which terms are asked about.
enum class CollinearAmong { causes, deviations };

/// A cause or a parameter deviation that is collinear with another cause of the library, or next to
/// nothing beside impacts.
std::optional<std::size_t> find_collinear_term(const Design& design, const Settings& settings,
                                               const Weights& weights, const Model& model,
                                               CollinearAmong asked);

}  // namespace sinew::diagnosis

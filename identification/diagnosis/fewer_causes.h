// SPDX-License-Identifier: GPL-3.0-or-later
// One cause in the place of several: a search that adds one at a time may have named the parts of
// what is one, values of the model among them.
#pragma once

#include <optional>
#include <vector>

#include "identification/diagnosis/select.h"

namespace sinew::diagnosis {

/// A cause and those that it makes needless, as library_index() counts them.
struct FewerCauses {
  int candidate = 0;
  std::vector<int> replaced;
  double p_family = 1.0;  ///< the smallest of theirs
};

/// The replacement that is worth most, deviance and price of all parameters and names together;
/// nothing where none is worth it. `adopted`: of select_deviations().
std::optional<FewerCauses> find_fewer_causes(const Design& design, const Library& library,
                                             const Settings& settings, const Selection& adopted);

/// The selection with free values after a replacement; values of the model are chosen anew.
Selection replace_causes(const Design& design, const Library& library, const Settings& settings,
                         const Selection& found, const FewerCauses& fewer);

}  // namespace sinew::diagnosis

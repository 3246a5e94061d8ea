// SPDX-License-Identifier: GPL-3.0-or-later
// A derived function used within another derivation.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/expressions/definition_list.h"

namespace sinew {

/// The function's results at `inputs` (all arguments one after the other), one vector an output;
/// its definitions are appended to `list`. Throws std::invalid_argument where the number of inputs
/// is not the function's.
std::vector<std::vector<GiNaC::ex>> inlined(DefinitionList& list, const Function& function,
                                            const std::vector<GiNaC::ex>& inputs);

}  // namespace sinew

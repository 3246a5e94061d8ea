// SPDX-License-Identifier: GPL-3.0-or-later
// The regressors of all effects as functions to emit (generated/effects).
#pragma once

#include <vector>

#include "generator/function.h"
#include "symbolic/effects/effect.h"

namespace sinew {

/// <id>(signals 8[, shape k][, memory m] -> columns n[, next m]): the terms that the effect's
/// coefficients multiply, in the order of Effect::columns; signals as signal_list() lists them.
Function regressor_function(const Effect& effect);

/// One for every effect of the catalogue.
std::vector<Function> effect_functions();

}  // namespace sinew

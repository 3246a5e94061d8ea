// SPDX-License-Identifier: GPL-3.0-or-later
// What functions of a model compute alike, at the same place or at others, as functions of the file
// alone. A search that evaluates the same equations at several points calls one part for each.
#pragma once

#include <vector>

#include "generator/calls/find_calls.h"

namespace sinew {

/// Makes the functions call parts, and gives the parts, those that others call first. A part leaves
/// clearly fewer operations to write in all and makes no function cost more than limits.growth
/// allows; results have the bits of the graphs.
std::vector<CallingFunction> find_parts(std::vector<CallingFunction>& functions,
                                        const LoopLimits& limits);

}  // namespace sinew

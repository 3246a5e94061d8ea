// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generator/function.h"
#include "generator/graph.h"

namespace sinew {

/// Turns a derived function into a graph.
///
/// GiNaC orders terms by memory address and moves signs with them. Here operands get a total order
/// (by structure, never by address) and a sign rule (the first term of a sum is positive), so that
/// the result is the same in every run.
/// Throws std::invalid_argument naming the function and the expression that has no operation.
Graph lower(const Function& function);

}  // namespace sinew

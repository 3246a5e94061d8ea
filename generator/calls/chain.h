// SPDX-License-Identifier: GPL-3.0-or-later
// A function that is others one after the other (Function::chain).
#pragma once

#include <string>
#include <vector>

#include "generator/graph.h"

namespace sinew {

/// The place of a function of that name. Throws std::invalid_argument where there is none.
std::size_t place_of_function(const std::vector<Graph>& functions, const std::string& name);

/// Graphs of chains become those of their functions, one after the other: bits and operations are
/// those of the calls. Throws std::invalid_argument where an argument is neither an input nor a
/// result of an earlier one, or the last one's results are not the chain's.
void join_chains(std::vector<Graph>& functions);

}  // namespace sinew

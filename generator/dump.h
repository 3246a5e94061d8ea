// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/graph.h"

namespace sinew {

/// One line a node: "%7 = multiply %3 %5   # label".
std::string dump_text(const Graph& graph);

/// The same as a graph for Graphviz.
std::string dump_dot(const Graph& graph);

}  // namespace sinew

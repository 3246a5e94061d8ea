// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "generator/graph.h"

namespace sinew {

/// Rebuilds `graph` node by node. `make` gets the new graph and the old node with its operands
/// already replaced, and returns the value that takes the node's place. Labels and results follow.
Graph rewrite(const Graph& graph, const std::function<Value(Graph&, const Node&)>& make);

/// As above, and also tells `make` the node's number in the old graph.
Graph rewrite(const Graph& graph, const std::function<Value(Graph&, const Node&, Value)>& make);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/graph.h"

namespace sinew {

/// One transformation of a graph that keeps its results (up to rounding).
struct Pass {
  std::string name;
  std::function<Graph(const Graph&)> run;
};

/// The passes in the order in which `optimise` runs them.
const std::vector<Pass>& pipeline();

/// "share, fold_constants, ...": every name once, for messages.
std::string pass_names();

/// Runs the pipeline, leaving out the passes named in `without`.
/// Throws std::invalid_argument where a name in `without` is no pass.
Graph optimise(const Graph& graph, const std::vector<std::string>& without = {});

}  // namespace sinew

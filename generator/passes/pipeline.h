// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/graph.h"
#include "generator/target.h"

namespace sinew {

/// One transformation of a graph that keeps its results (up to rounding).
struct Pass {
  std::string name;
  std::function<Graph(const Graph&)> run;
};

/// The passes for a target, in the order in which `optimise` runs them.
std::vector<Pass> pipeline(const Target& target = {});

/// "share, fold_constants, ...": every name once, for messages; those for some targets only too.
std::string pass_names();

/// Runs the pipeline, leaving out the passes named in `without`.
/// Throws std::invalid_argument where a name in `without` is no pass.
Graph optimise(const Graph& graph, const std::vector<std::string>& without = {},
               const Target& target = {});

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Every pass by name; each is described, with an example, at the head of its file.
#pragma once

#include "generator/graph.h"

namespace sinew {

Graph share(const Graph& graph);
Graph fold_constants(const Graph& graph);
Graph move_signs(const Graph& graph);
Graph expand_powers(const Graph& graph);
Graph pair_sincos(const Graph& graph);
Graph combine_constants(const Graph& graph);
Graph factor_sums(const Graph& graph);
Graph distribute_constants(const Graph& graph);
Graph reduce_strength(const Graph& graph);
Graph share_reciprocals(const Graph& graph);
Graph contract_trigonometry(const Graph& graph);
Graph remove_dead(const Graph& graph);
Graph fuse(const Graph& graph);
Graph schedule(const Graph& graph);

}  // namespace sinew

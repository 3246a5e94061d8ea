// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the values that several functions compute alike become a part: those that leave most
// beside what it costs to pass the part's results.
#pragma once

#include <vector>

#include "generator/graph.h"

namespace sinew {

/// What the values of a graph have to do with a part of it, by value.
struct PartValues {
  std::vector<bool> may;     ///< may belong to it, as then all may that it needs
  std::vector<bool> beside;  ///< is needed elsewhere, too, by something that may not belong to it
  std::vector<double> gain;  ///< instructions that its belonging saves
  std::vector<double> cost;  ///< of passing it, where something outside needs it
};

/// Whether each value belongs to the part that saves most, all its costs counted. What one call
/// gives (`inputs` with values) belongs to it as a whole or not at all.
std::vector<bool> cut_part(const Graph& graph, const PartValues& values);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// How a loop stands in C, apart from the statements of its body.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/loops/plan.h"
#include "generator/target.h"

namespace sinew {

struct LoopText {
  std::vector<std::string>
      tables;  ///< declarations before the loop, of what passes choose from, too
  std::vector<std::string> arrays;  ///< by result: the array of what is kept
  std::string head;                 ///< "for (int i1 = 0; i1 < 36; ++i1) {"
  std::vector<std::string> copies;  ///< first in the body: what the pass before gave
  std::vector<std::string> leaves;  ///< by leaf; empty where it is shared
  std::vector<std::string>
      results;  ///< by result: the variable carried, the element stored or kept
};

/// What a loop needs of the function that it stands in.
struct LoopSurroundings {
  /// Makes a name from a prefix that nothing else in the function has.
  std::function<std::string(const std::string&)> fresh;
  std::function<std::string(Value)> text;  ///< a value as the C names it
  /// The array of a loop that kept a value, and its place there; "" where none did.
  std::function<std::pair<std::string, int>(Value)> kept;
};

LoopText loop_text(const Loop& loop, const Graph& graph, const Target& target,
                   const LoopSurroundings& around);

}  // namespace sinew

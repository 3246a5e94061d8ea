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
  std::vector<std::string> tables;   ///< declarations before the loop
  std::string head;                  ///< "for (int i1 = 0; i1 < 36; ++i1) {"
  std::vector<std::string> copies;   ///< first in the body: what the pass before gave
  std::vector<std::string> leaves;   ///< by leaf; empty where it is shared
  std::vector<std::string> results;  ///< by result: the variable carried or the element stored
};

/// `fresh` makes a name from a prefix that nothing else in the function has.
LoopText loop_text(const Loop& loop, const Graph& graph, const Target& target,
                   const std::function<std::string(const std::string&)>& fresh);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the variables of one emitted function.
#pragma once

#include <set>
#include <string>

#include "generator/graph.h"
#include "generator/target.h"

namespace sinew {

/// Gives every variable of a function, its loops' bodies included, a name of its own, which is
/// neither a word of C nor an argument nor what the file calls.
class LocalNames {
 public:
  LocalNames(const Graph& graph, const Target& target);

  /// The label itself, or with the first number that makes it a name of its own: "gap", "gap_2".
  std::string labelled(const std::string& label);
  /// The prefix with the function's next number: "t1", "t2".
  std::string numbered(const std::string& prefix);

 private:
  std::set<std::string> taken_;
  int number_ = 0;
};

}  // namespace sinew

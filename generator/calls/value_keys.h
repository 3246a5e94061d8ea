// SPDX-License-Identifier: GPL-3.0-or-later
// Which values of several functions are the same: the same operation on the same operands.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "generator/graph.h"

namespace sinew {

/// Numbers for values, equal where two functions compute the same, bit for bit. An input element is
/// the same where the arguments have the same name, size and way of passing.
class ValueKeys {
 public:
  /// The numbers of a graph's values.
  std::vector<int> of(const Graph& graph);

 private:
  using Operation = std::tuple<Op, std::int32_t, std::array<int, 3>, std::uint64_t>;

  int number_of(const Operation& operation);
  int number_of_input(const Graph& graph, int index);

  std::map<Operation, int> operations_;
  std::map<std::tuple<std::string, int, bool, int>, int> inputs_;
  int next_ = 0;
};

}  // namespace sinew

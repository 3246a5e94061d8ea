// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/graph.h"
#include "generator/loops/plan.h"
#include "generator/target.h"

namespace sinew {

/// How array elements are written: element k of an input or output.
struct ArrayNames {
  std::function<std::string(const Port& port, int element)> element;
  bool side_by_side = true;   ///< evaluate several angles by one call; off inside a loop over
                              ///< states, where all results are stored at the end, too
  bool stores_last = false;   ///< all results are stored at the end
  bool shared = false;        ///< the file's copies of long functions are called (runtime_calls.h)
  bool int_statuses = false;  ///< a status is an int, else (in a loop's body) a number
  /// The call that fills an input array, from the numbers that are passed to it.
  std::function<std::vector<std::string>(const Port& port, const std::vector<std::string>& passed)>
      call = {};
};

/// As the arguments of a function are: q[2], a number by its name, *status.
ArrayNames array_names();

/// Whether any element of the named input is used.
bool reads_port(const Graph& graph, const std::string& name);

/// Whether results are stored as soon as they are computed: those of a function with more results
/// than a register file holds. Others are stored at the end: a store makes the compiler read the
/// inputs again, since it might have changed them.
bool stores_early(const Graph& graph);

/// The body of a function: declarations and loops in the plan's order, and the stores of the
/// results. A value gets a name where it is used more than once or would make a line too long, the
/// sooner where the derivation has a name for it; the rest is written in place.
std::vector<std::string> statements(const Graph& graph, const Plan& plan, const Target& target,
                                    const ArrayNames& names);

}  // namespace sinew

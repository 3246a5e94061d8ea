// SPDX-License-Identifier: GPL-3.0-or-later
// Operations that are calls of the runtime, and the copies of its functions that a file shares.
#pragma once

#include <string>
#include <vector>

#include "generator/graph.h"
#include "generator/target.h"

namespace sinew {

/// "sinew_atan": the runtime's function of an operation, without the scalar's suffix; nullptr for
/// what C has operators for, and for sine and cosine, which come in pairs.
const char* runtime_function(Op op);

/// "sinew_one_atan": what a shared copy of an operation's function is called; empty where it is
/// short.
std::string shared_name(Op op, const Target& target);

/// A function of the runtime that is not inlined: one copy for a whole file of emitted C.
struct SharedFunction {
  std::string name;
  std::string definition;  ///< C text
};

/// The ones that a model calls: every long function that its graphs need more than once, sines and
/// cosines among them where the target is short of room. A call costs few of their instructions.
std::vector<SharedFunction> shared_functions(const std::vector<Graph>& graphs,
                                             const Target& target);

}  // namespace sinew

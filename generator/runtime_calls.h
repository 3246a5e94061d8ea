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

/// "sinew_one_sincos4": the same for the sines and cosines of 1, 2 or 4 angles side by side.
std::string shared_sincos_name(std::size_t angles, const Target& target);

/// One copy of a function of the runtime for a whole file of emitted C.
struct SharedFunction {
  std::string name;
  std::string definition;  ///< C text, from "static" on
};

/// Copies of the long functions that these graphs call; those of sines and cosines for every number
/// of angles that the target has side by side.
std::vector<SharedFunction> shared_functions(const std::vector<Graph>& graphs,
                                             const Target& target);

}  // namespace sinew

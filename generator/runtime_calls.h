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

/// "sinew_one_sincos2": the same for the sines and cosines of one angle, or of two side by side.
std::string shared_sincos_name(std::size_t angles, const Target& target);
/// What it gives: "struct sinew_sines2", with the arrays s and c.
std::string shared_sincos_type(std::size_t angles);

/// One copy of a function of the runtime for a whole file of emitted C.
struct SharedFunction {
  std::string name;
  std::string definition;  ///< C text, from "static" on
  std::string type;        ///< C text of the type that it gives, where it is one of its own
};

/// Copies of the long functions that these graphs call; those of sines and cosines for one angle
/// and, where the target has them side by side, for two.
std::vector<SharedFunction> shared_functions(const std::vector<Graph>& graphs,
                                             const Target& target);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/model.h"

namespace sinew {

/// The runtime's headers that emitted C includes, and a refusal to compile where the target's
/// processor lacks what was asked for.
std::string runtime_includes(const Target& target);

/// Text of <model>.c: every function of the model, straight-line, one value a statement.
std::string emit_c(const EmittedModel& model);

/// "void index_bias(const double q[SINEW_AT_LEAST(4)], ..., double h[SINEW_AT_LEAST(4)])".
std::string signature(const EmittedModel& model, const Graph& graph);

/// Comment block that opens every emitted file.
std::string file_comment(const EmittedModel& model, const std::string& what);

}  // namespace sinew

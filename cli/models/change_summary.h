// SPDX-License-Identifier: GPL-3.0-or-later
// What a change of a model does to its emitted functions, from what was emitted before: its C, its
// manifest and its reference.csv. Needs no compiler.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/model.h"

namespace sinew {

/// By how much a result changed in one state, over all its elements.
struct ValueChange {
  double largest = 0;              ///< in the result's unit
  std::optional<double> relative;  ///< of the largest element before; none where all were 0
};

struct ResultChange {
  std::string name, unit;
  ValueChange reference;  ///< in the reference state as it was before the change
  ValueChange beside;     ///< in the second state of reference.csv, also as it was
};

struct FunctionChange {
  enum class Kind { unchanged, changed, added, removed };
  std::string name;
  Kind kind = Kind::unchanged;
  std::optional<int> operations_before, operations_after;  ///< multiplications and additions
  std::vector<ResultChange> results;  ///< empty unless the old values are known for these arguments
};

/// Every function of the model and those that are gone, in the order of the model. `folder` holds
/// what was emitted before; where it is missing every function is added. `code`: emit_c(model).
std::vector<FunctionChange> function_changes(const std::filesystem::path& folder,
                                             const EmittedModel& model, const std::string& code);

/// For people: the functions that changed, a line each, and how many did not.
std::string summary_text(const std::vector<FunctionChange>& changes);
nlohmann::ordered_json summary_json(const std::vector<FunctionChange>& changes);

}  // namespace sinew

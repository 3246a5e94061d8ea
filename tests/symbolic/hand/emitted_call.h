// SPDX-License-Identifier: GPL-3.0-or-later
// Committed C by its catalogue: any function of any model in one line.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/sinew_catalogue.h"

namespace sinew_tests {

using Values = std::vector<double>;

inline const sinew_function* find_function(const sinew_catalogue& model, const std::string& name) {
  for (int i = 0; i < model.function_count; ++i)
    if (model.functions[i].name == name ||
        model.functions[i].name == std::string(model.model) + "_" + name)
      return &model.functions[i];
  return nullptr;
}

/// All inputs one after the other in, all results one after the other out.
inline Values call(const sinew_catalogue& model, const std::string& name, const Values& inputs) {
  const sinew_function* function = find_function(model, name);
  if (!function) throw std::out_of_range(fmt::format("{} offers no {}", model.model, name));
  if (static_cast<int>(inputs.size()) != function->input_size)
    throw std::invalid_argument(fmt::format("{} takes {} numbers", name, function->input_size));
  Values results(static_cast<std::size_t>(function->output_size));
  function->call(inputs.data(), results.data());
  return results;
}

inline Values joined(Values a, const Values& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace sinew_tests

// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/wrappers/moving_model.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sinew {

bool has_function(const WrappedModel& model, const std::string& name,
                  const std::vector<std::string>& inputs) {
  const WrappedFunction* function = model.find(name);
  if (!function || function->inputs.size() != inputs.size()) return false;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (function->inputs[i].name != inputs[i]) return false;
  return true;
}

void require_moving(const WrappedModel& model, const std::string& wrapper) {
  if (model.scalar != "double")
    throw std::runtime_error(fmt::format(
        "--{}: {} is emitted in float; expected double (leave out --scalar)", wrapper, model.name));
  if (!has_function(model, "forward_dynamics", {"q", "qd", "tau"}))
    throw std::runtime_error(
        fmt::format("--{}: {} has no forward_dynamics(q, qd, tau); expected the model of a "
                    "mechanism with masses, without --runtime-parameters",
                    wrapper, model.name));
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// What wrappers that move a mechanism ask of its model.
#pragma once

#include "generator/wrappers/wrapped_model.h"

namespace sinew {

/// Whether the function is there with these arguments and no others.
bool has_function(const WrappedModel& model, const std::string& name,
                  const std::vector<std::string>& inputs);

/// Throws std::runtime_error unless the model is one of a mechanism in double precision with
/// forward_dynamics(q, qd, tau). `wrapper` names what asks.
void require_moving(const WrappedModel& model, const std::string& wrapper);

}  // namespace sinew

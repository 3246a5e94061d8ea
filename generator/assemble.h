// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/function.h"
#include "generator/model.h"

namespace sinew {

/// What a model is called and where it comes from.
struct ModelIdentity {
  std::string name;
  std::string description;
  std::string hash;
  std::vector<std::string> notes;
  Naming naming = {};
};

/// Lowers and optimises every function. `without`: passes to leave out.
EmittedModel assemble(const ModelIdentity& identity, const std::vector<Function>& functions,
                      const Target& target, const std::vector<std::string>& without = {});

/// Weighted operations of a function once emitted; see Cost::weight.
double emitted_cost(const Function& function);

}  // namespace sinew

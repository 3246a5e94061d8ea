// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/assemble.h"

#include "generator/calls/chain.h"
#include "generator/cost.h"
#include "generator/lower.h"
#include "generator/passes/pipeline.h"

namespace sinew {

EmittedModel assemble(const ModelIdentity& identity, const std::vector<Function>& functions,
                      const Target& target, const std::vector<std::string>& without) {
  EmittedModel model{identity.name, identity.description, identity.hash, identity.notes, {},
                     target,        identity.naming};
  for (const Function& function : functions) {
    model.functions.push_back(optimise(lower(function), without, target));
    model.functions.back().chain = function.chain;
  }
  join_chains(model.functions);
  return model;
}

/// Order does not change a count, so the schedule is left out here.
double emitted_cost(const Function& function) {
  return count_operations(optimise(lower(function), {"schedule"})).weight();
}

}  // namespace sinew

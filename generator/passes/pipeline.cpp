// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/passes/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "generator/passes/passes.h"

namespace sinew {

std::vector<Pass> pipeline(const Target& target) {
  std::vector<Pass> passes{
      {"share", share},
      {"fold_constants", fold_constants},
      {"expand_powers", expand_powers},
      {"pair_sincos", pair_sincos},
      {"contract_trigonometry", contract_trigonometry},
      {"move_signs", move_signs},
      {"combine_constants", combine_constants},
      {"factor_sums", factor_sums},
      {"distribute_constants", distribute_constants},
      {"share_reciprocals", share_reciprocals},
      {"reduce_strength", reduce_strength},
      {"combine_constants", combine_constants},
      {"fold_constants", fold_constants},
      {"move_signs", move_signs},
      {"share", share},
      {"remove_dead", remove_dead},
  };
  if (target.fused) passes.push_back({"fuse", fuse});
  passes.push_back({"schedule", schedule});
  return passes;
}

std::string pass_names() {
  std::string names;
  std::set<std::string> seen;
  for (const Pass& pass : pipeline({.fused = true}))
    if (seen.insert(pass.name).second) names += (names.empty() ? "" : ", ") + pass.name;
  return names;
}

Graph optimise(const Graph& graph, const std::vector<std::string>& without, const Target& target) {
  const std::vector<Pass> known = pipeline({.fused = true});
  for (const std::string& name : without)
    if (std::none_of(known.begin(), known.end(), [&](const Pass& p) { return p.name == name; }))
      throw std::invalid_argument(
          fmt::format("no pass is called '{}'; expected one of {}", name, pass_names()));
  Graph result = graph;
  for (const Pass& pass : pipeline(target))
    if (std::find(without.begin(), without.end(), pass.name) == without.end())
      result = pass.run(result);
  return result;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/definition_list.h"

#include <set>

namespace sinew {

GiNaC::ex DefinitionList::define(const std::string& name, const GiNaC::ex& value) {
  if (GiNaC::is_a<GiNaC::numeric>(value) || GiNaC::is_a<GiNaC::symbol>(value)) return value;
  const GiNaC::symbol symbol(unique(name));
  positions_[symbol] = items_.size();
  items_.push_back({symbol, value});
  return symbol;
}

std::optional<std::size_t> DefinitionList::position(const GiNaC::ex& symbol) const {
  const auto found = positions_.find(symbol);
  if (found == positions_.end()) return std::nullopt;
  return found->second;
}

std::vector<std::size_t> DefinitionList::used_by(const GiNaC::ex& value) const {
  std::set<std::size_t> used;  // by position: GiNaC's own order changes from run to run
  for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::symbol>(*part))
      if (const auto at = position(*part)) used.insert(*at);
  return {used.begin(), used.end()};
}

std::string DefinitionList::unique(const std::string& name) {
  std::string candidate = name;
  while (true) {
    const int uses = uses_[candidate]++;
    if (uses == 0) return candidate;
    candidate = name + "_" + std::to_string(uses_[name]++);
  }
}

}  // namespace sinew

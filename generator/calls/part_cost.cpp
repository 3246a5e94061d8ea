// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/part_cost.h"

#include <algorithm>

#include "generator/calls/places.h"

namespace sinew {
namespace {

/// A call with the numbers that it passes, what it saves on the stack, its return: Cortex-A9. What
/// it gives is counted where it is loaded.
constexpr int executed_by_call = 24;
constexpr int written_by_call = 4;

int loads_of_calls(const CallingFunction& function) {
  const std::vector<const Call*> calls = calls_by_port(function);
  int loads = 0;
  for (const Node& node : function.rest.nodes())
    loads += node.op == Op::input && calls[function.rest.port_of_input(node.index)] != nullptr;
  return loads;
}

}  // namespace

PartCosts::PartCosts(const std::vector<CallingFunction>& functions, double most_growth)
    : most_growth_(most_growth) {
  for (const CallingFunction& function : functions) add(function);
  for (std::size_t f = 0; f < functions.size(); ++f)
    allowed_.push_back(static_cast<int>(of(f).executed * most_growth_));
}

void PartCosts::replace(std::size_t function, const CallingFunction& now) {
  sizes_[function] = own(now);
}

void PartCosts::add(const CallingFunction& part) {
  names_.push_back(part.rest.name);
  sizes_.push_back(own(part));
}

PlanSize PartCosts::of(const CallingFunction& function, int new_part) const {
  return total(own(function), new_part);
}

std::size_t PartCosts::elements(const CallingFunction& function, std::size_t new_part) const {
  return elements(own(function), new_part);
}

std::size_t PartCosts::elements(const Own& own, std::size_t new_part) const {
  std::size_t deepest = 0;
  for (const std::string& name : own.calls) {
    const auto known = std::find(names_.begin(), names_.end(), name);
    deepest = std::max(
        deepest,
        known == names_.end()
            ? new_part
            : elements(sizes_[static_cast<std::size_t>(known - names_.begin())], new_part));
  }
  return own.elements + deepest;
}

bool PartCosts::is_dear(std::size_t function, int growth) const {
  for (std::size_t g = 0; g < allowed_.size(); ++g)
    if (const int count = runs(g, function);
        count > 0 && of(g).executed + count * growth > allowed_[g])
      return true;
  return false;
}

int PartCosts::written_for_calls(const CallingFunction& function) {
  return loads_of_calls(function) + written_by_call * static_cast<int>(function.calls.size());
}

bool PartCosts::is_deep(std::size_t function, std::size_t elements, std::size_t most) const {
  const std::size_t before = this->elements(sizes_[function], 0);
  for (std::size_t g = 0; g < sizes_.size(); ++g)
    if (runs(g, function) > 0 && this->elements(sizes_[g], 0) + elements - before > most)
      return true;
  return false;
}

/// With the loads of what calls give.
PartCosts::Own PartCosts::own(const CallingFunction& function) {
  Own result{sinew::size_of(function.rest, straight_plan(function.rest)),
             {},
             array_elements(function.calls)};
  const int loads = loads_of_calls(function);
  result.size.written += loads;
  result.size.executed += loads;
  for (const Call& call : function.calls) result.calls.push_back(call.function);
  return result;
}

PlanSize PartCosts::total(const Own& own, int new_part) const {
  PlanSize size = own.size;
  for (const std::string& name : own.calls) {
    size.written += written_by_call;
    size.executed += executed_by_call + executed_in(name, new_part);
  }
  return size;
}

int PartCosts::executed_in(const std::string& name, int new_part) const {
  for (std::size_t f = 0; f < names_.size(); ++f)
    if (names_[f] == name) return of(f).executed;
  return new_part;
}

/// How often a function runs another one; itself once.
int PartCosts::runs(std::size_t caller, std::size_t callee) const {
  if (caller == callee) return 1;
  int count = 0;
  for (const std::string& name : sizes_[caller].calls)
    for (std::size_t f = 0; f < names_.size(); ++f)
      if (names_[f] == name) count += runs(f, callee);
  return count;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/differentiate.h"

#include <optional>

#include "symbolic/expressions/piecewise.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::is_a;

bool is_call(const ex& value, unsigned serial) {
  return is_a<GiNaC::function>(value) &&
         GiNaC::ex_to<GiNaC::function>(value).get_serial() == serial;
}

/// Case distinctions as (condition, a, b): the derivative chooses between a' and b' instead of
/// weighting them with 0 and 1, so that the side not taken cannot spoil the result.
struct Cases {
  ex condition, a, b;
};

std::optional<Cases> cases_of(const ex& value) {
  if (is_call(value, choose_SERIAL::serial)) return Cases{value.op(0), value.op(1), value.op(2)};
  if (is_call(value, minimum_SERIAL::serial))
    return Cases{value.op(1) - value.op(0), value.op(0), value.op(1)};
  if (is_call(value, maximum_SERIAL::serial))
    return Cases{value.op(0) - value.op(1), value.op(0), value.op(1)};
  return std::nullopt;
}

bool is_root(const ex& value) {
  return is_a<GiNaC::power>(value) && value.op(1).is_equal(GiNaC::numeric(1, 2));
}

/// Denominator of a fraction: the product of all factors with exponent -1, or 1.
ex denominator_of(const ex& value) {
  const auto below = [](const ex& factor) -> ex {
    return is_a<GiNaC::power>(factor) && factor.op(1).is_equal(-1) ? factor.op(0) : ex(1);
  };
  if (!is_a<GiNaC::mul>(value)) return below(value);
  ex result = 1;
  for (std::size_t i = 0; i < value.nops(); ++i) result *= below(value.op(i));
  return result;
}

/// d(value)/d(symbol) with everything else held, using the value's own symbol where that is
/// shorter: a root's derivative needs the root, a fraction's the fraction.
ex partial(const ex& value, const ex& own, const GiNaC::symbol& symbol) {
  if (const auto cases = cases_of(value))
    return choose(cases->condition, cases->a.diff(symbol), cases->b.diff(symbol));
  if (is_root(value)) return (value.op(0).diff(symbol) / 2) / own;
  if (const ex below = denominator_of(value); !below.is_equal(1))
    return ((value * below).diff(symbol) - own * below.diff(symbol)) / below;
  return value.diff(symbol);
}

}  // namespace

ForwardDerivative::ForwardDerivative(DefinitionList& list, const GiNaC::symbol& variable,
                                     std::string suffix)
    : list_(list), suffix_(std::move(suffix)) {
  seed(variable, 1);
}

void ForwardDerivative::seed(const GiNaC::symbol& input, const ex& derivative) {
  known_[input] = derivative;
  if (!list_.position(input)) inputs_.push_back(input);
}

ex ForwardDerivative::of(const ex& value) {
  return total(value, value);
}

ex ForwardDerivative::of_definition(std::size_t position) {
  const Definition definition = list_.items()[position];  // copied: the list grows below
  if (const auto found = known_.find(definition.symbol); found != known_.end())
    return found->second;
  const ex derivative = total(definition.value, definition.symbol);
  return known_[definition.symbol] =
             list_.define(definition.symbol.get_name() + "_by_" + suffix_, derivative);
}

// by_parts() writes definitions down: calls that share an expression would come in the compiler's
// order.
ex ForwardDerivative::total(const ex& value, const ex& own) {
  if (const auto cases = cases_of(value)) {
    const ex a = by_parts(cases->a), b = by_parts(cases->b);
    return choose(cases->condition, a, b);
  }
  if (is_root(value)) return (by_parts(value.op(0)) / 2) / own;
  if (const ex below = denominator_of(value); !below.is_equal(1)) {
    const ex above = by_parts(value * below);
    return (above - own * by_parts(below)) / below;
  }
  return by_parts(value);
}

ex ForwardDerivative::by_parts(const ex& value) {
  ex sum = 0;
  for (const GiNaC::symbol& input : inputs_)
    if (value.has(input)) sum += value.diff(input) * known_[input];
  for (const std::size_t position : list_.used_by(value)) {
    const ex inner = of_definition(position);
    if (!inner.is_zero()) sum += value.diff(list_.items()[position].symbol) * inner;
  }
  return sum;
}

std::vector<ex> jacobian(DefinitionList& list, const std::vector<ex>& values,
                         const std::vector<GiNaC::symbol>& variables) {
  std::vector<ex> result(values.size() * variables.size());
  for (std::size_t j = 0; j < variables.size(); ++j) {
    ForwardDerivative derivative(list, variables[j], variables[j].get_name());
    for (std::size_t i = 0; i < values.size(); ++i)
      result[i * variables.size() + j] = derivative.of(values[i]);
  }
  return result;
}

std::vector<ex> gradient(DefinitionList& list, const ex& value,
                         const std::vector<GiNaC::symbol>& variables, const std::string& prefix) {
  std::map<std::size_t, ex> adjoints;  // of definitions, by position
  std::vector<ex> result(variables.size());
  const auto spread = [&](const ex& part, const ex& own, const ex& adjoint) {
    for (std::size_t j = 0; j < variables.size(); ++j)
      if (part.has(variables[j])) result[j] += adjoint * partial(part, own, variables[j]);
    for (const std::size_t position : list.used_by(part))
      adjoints[position] += adjoint * partial(part, own, list.items()[position].symbol);
  };
  spread(value, value, 1);
  while (!adjoints.empty()) {
    const auto last = std::prev(adjoints.end());  // users before what they use
    const Definition definition = list.items()[last->first];
    const ex adjoint = list.define(prefix + "_by_" + definition.symbol.get_name(), last->second);
    adjoints.erase(last);
    if (!adjoint.is_zero()) spread(definition.value, definition.symbol, adjoint);
  }
  return result;
}

std::vector<ex> hessian(DefinitionList& list, const ex& value,
                        const std::vector<GiNaC::symbol>& variables) {
  const std::size_t n = variables.size();
  std::vector<ForwardDerivative> by;
  for (const GiNaC::symbol& variable : variables)
    by.emplace_back(list, variable, variable.get_name());
  std::vector<ex> result(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    const ex slope = list.define("slope_by_" + variables[i].get_name(), by[i].of(value));
    for (std::size_t j = i; j < n; ++j) result[i * n + j] = result[j * n + i] = by[j].of(slope);
  }
  return result;
}

}  // namespace sinew

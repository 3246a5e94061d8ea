// SPDX-License-Identifier: GPL-3.0-or-later
// combine_constants: the constants of one sum or product become one.
//
//   (2 * a) * (3 * b)   ->   6 * (a * b)          (a + 2) + (b - 3)   ->   a + b - 1
#include "generator/passes/chains.h"
#include "generator/passes/passes.h"

namespace sinew {
namespace {

Value combine_sum(const Graph& from, Graph& to, const std::vector<Term>& terms,
                  const std::vector<Value>& moved) {
  double constant = 0.0;
  int constants = 0;
  std::vector<Term> rest;
  for (const Term& term : terms) {
    if (from.is_constant(term.value)) {
      constant += term.negative ? -from[term.value].constant : from[term.value].constant;
      ++constants;
    } else {
      rest.push_back({moved[static_cast<std::size_t>(term.value)], term.negative});
    }
  }
  if (constants > 0 && constant != 0.0)
    rest.push_back({to.constant(constant < 0 ? -constant : constant), constant < 0});
  return make_sum(to, rest);
}

Value combine_product(const Graph& from, Graph& to, const std::vector<Value>& factors,
                      const std::vector<Value>& moved) {
  double constant = 1.0;
  std::vector<Value> rest;
  for (Value v : factors) {
    if (from.is_constant(v))
      constant *= from[v].constant;
    else
      rest.push_back(moved[static_cast<std::size_t>(v)]);
  }
  if (constant != 1.0 || rest.empty()) rest.insert(rest.begin(), to.constant(constant));
  return make_product(to, rest);
}

int constants_among(const Graph& g, const std::vector<Value>& values) {
  int count = 0;
  for (Value v : values) count += g.is_constant(v);
  return count;
}

std::vector<Value> values_of(const std::vector<Term>& terms) {
  std::vector<Value> values;
  for (const Term& t : terms) values.push_back(t.value);
  return values;
}

}  // namespace

Graph combine_constants(const Graph& graph) {
  const std::vector<int> uses = use_counts(graph);
  const std::vector<bool> inner = inner_links(graph, uses);
  Graph to = graph.empty_like();
  std::vector<Value> moved(static_cast<std::size_t>(graph.size()), no_value);
  for (Value v = 0; v < graph.size(); ++v) {
    Node node = graph[v];
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = moved[static_cast<std::size_t>(node.operand(i))];
    Value& target = moved[static_cast<std::size_t>(v)];
    const bool whole = !inner[static_cast<std::size_t>(v)];
    if (whole && is_sum(node)) {
      const std::vector<Term> terms = terms_of(graph, uses, v);
      if (constants_among(graph, values_of(terms)) > 1)
        target = combine_sum(graph, to, terms, moved);
    } else if (whole && node.op == Op::multiply) {
      const std::vector<Value> factors = factors_of(graph, uses, v);
      if (constants_among(graph, factors) > 1) target = combine_product(graph, to, factors, moved);
    }
    if (target == no_value) target = to.add(node);
    if (!to.is_constant(target) && to[target].op != Op::input) to.set_label(target, graph.label(v));
  }
  for (Port& port : to.outputs)
    for (Value& v : port.values) v = moved[static_cast<std::size_t>(v)];
  return to;
}

}  // namespace sinew

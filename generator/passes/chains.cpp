// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/passes/chains.h"

#include <algorithm>

namespace sinew {
namespace {

bool used_once(const std::vector<int>& uses, Value v) {
  return uses[static_cast<std::size_t>(v)] == 1;
}

/// A loop saves more than signs and factors that are taken out across a long sum's end.
bool stays_a_sum(const Graph& g, Value v) {
  if (g.label(v).empty()) return false;
  std::size_t terms = 1;
  for (Value rest = v; is_sum(g[rest]) && terms < terms_of_a_long_sum; rest = g[rest].a) ++terms;
  return terms >= terms_of_a_long_sum;
}

void collect_terms(const Graph& g, const std::vector<int>& uses, Value v, bool negative, bool top,
                   std::vector<Term>& terms) {
  const Node& n = g[v];
  if (!is_sum(n) || (!top && (!used_once(uses, v) || stays_a_sum(g, v)))) {
    terms.push_back({v, negative});
    return;
  }
  collect_terms(g, uses, n.a, negative, false, terms);
  collect_terms(g, uses, n.b, negative != (n.op == Op::subtract), false, terms);
}

void collect_factors(const Graph& g, const std::vector<int>& uses, Value v, bool top,
                     std::vector<Value>& factors) {
  const Node& n = g[v];
  if (n.op != Op::multiply || (!top && !used_once(uses, v))) {
    factors.push_back(v);
    return;
  }
  collect_factors(g, uses, n.a, false, factors);
  collect_factors(g, uses, n.b, false, factors);
}

}  // namespace

std::vector<Term> terms_of(const Graph& graph, const std::vector<int>& uses, Value v) {
  std::vector<Term> terms;
  collect_terms(graph, uses, v, false, true, terms);
  return terms;
}

std::vector<Value> factors_of(const Graph& graph, const std::vector<int>& uses, Value v) {
  std::vector<Value> factors;
  collect_factors(graph, uses, v, true, factors);
  return factors;
}

std::vector<bool> inner_links(const Graph& graph, const std::vector<int>& uses) {
  std::vector<bool> inner(static_cast<std::size_t>(graph.size()), false);
  for (const Node& n : graph.nodes())
    for (int i = 0; i < arity(n.op); ++i) {
      const Value v = n.operand(i);
      const bool same_kind = (is_sum(n) && is_sum(graph[v]) && !stays_a_sum(graph, v)) ||
                             (n.op == Op::multiply && graph[v].op == Op::multiply);
      if (same_kind && used_once(uses, v)) inner[static_cast<std::size_t>(v)] = true;
    }
  return inner;
}

Value make_sum(Graph& graph, std::vector<Term> terms) {
  if (terms.empty()) return graph.constant(0.0);
  const auto first =
      std::find_if(terms.begin(), terms.end(), [](const Term& t) { return !t.negative; });
  const bool all_negative = first == terms.end();
  if (!all_negative) std::rotate(terms.begin(), first, first + 1);
  Value total = terms.front().value;
  for (std::size_t i = 1; i < terms.size(); ++i)
    total = graph.make(terms[i].negative == all_negative ? Op::add : Op::subtract, total,
                       terms[i].value);
  return all_negative ? graph.make(Op::negate, total) : total;
}

Value make_product(Graph& graph, const std::vector<Value>& factors) {
  if (factors.empty()) return graph.constant(1.0);
  Value total = factors.front();
  for (std::size_t i = 1; i < factors.size(); ++i)
    total = graph.make(Op::multiply, total, factors[i]);
  return total;
}

}  // namespace sinew

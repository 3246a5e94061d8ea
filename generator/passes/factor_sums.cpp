// SPDX-License-Identifier: GPL-3.0-or-later
// factor_sums: a factor that several terms of a sum share is taken out, the most frequent first.
//
//   r = a*b + a*c - a*d + e    ->    r = a * (b + c - d) + e        (two multiplications fewer)
//
// Only products used nowhere else are opened, so nothing that is shared gets computed twice.
#include <algorithm>
#include <map>

#include "generator/passes/chains.h"
#include "generator/passes/passes.h"

namespace sinew {
namespace {

/// A term as a product of new values.
struct Product {
  std::vector<Value> factors;
  bool negative;
};

class SumFactoring {
 public:
  explicit SumFactoring(Graph& to) : to_(to) {}

  Value build(std::vector<Product> terms) {
    const Value common = most_frequent(terms);
    if (common == no_value) return plain(terms);
    std::vector<Product> inside, outside;
    for (Product& term : terms) {
      const auto at = std::find(term.factors.begin(), term.factors.end(), common);
      if (at == term.factors.end()) {
        outside.push_back(term);
      } else {
        term.factors.erase(at);
        inside.push_back(term);
      }
    }
    Term grouped = signed_value(build(inside));
    grouped.value = to_.make(Op::multiply, common, grouped.value);
    outside.insert(outside.begin(), {{grouped.value}, grouped.negative});
    return build(outside);
  }

 private:
  /// Strips a negation that `make_sum` had to put in front.
  Term signed_value(Value v) const {
    if (to_[v].op == Op::negate) return {to_[v].a, true};
    return {v, false};
  }

  /// Of products: a + a*b has as many operations as a * (1 + b).
  Value most_frequent(const std::vector<Product>& terms) const {
    std::map<Value, int> counts;
    for (const Product& term : terms) {
      if (term.factors.size() < 2) continue;
      std::vector<Value> seen;
      for (Value f : term.factors)
        if (std::find(seen.begin(), seen.end(), f) == seen.end()) {
          seen.push_back(f);
          ++counts[f];
        }
    }
    Value best = no_value;
    int most = 1;
    for (const auto& [value, count] : counts)
      if (count > most) {
        most = count;
        best = value;
      }
    return best;
  }

  Value plain(const std::vector<Product>& terms) {
    std::vector<Term> sum;
    for (const Product& term : terms)
      sum.push_back({make_product(to_, term.factors), term.negative});
    return make_sum(to_, sum);
  }

  Graph& to_;
};

}  // namespace

Graph factor_sums(const Graph& graph) {
  const std::vector<int> uses = use_counts(graph);
  const std::vector<bool> inner = inner_links(graph, uses);
  Graph to = graph.empty_like();
  std::vector<Value> moved(static_cast<std::size_t>(graph.size()), no_value);
  SumFactoring factoring(to);
  for (Value v = 0; v < graph.size(); ++v) {
    Node node = graph[v];
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = moved[static_cast<std::size_t>(node.operand(i))];
    Value& target = moved[static_cast<std::size_t>(v)];
    if (is_sum(node) && !inner[static_cast<std::size_t>(v)]) {
      std::vector<Product> terms;
      for (const Term& term : terms_of(graph, uses, v)) {
        Product product{{}, term.negative};
        const bool open = uses[static_cast<std::size_t>(term.value)] == 1;
        if (open && graph[term.value].op == Op::multiply)
          for (Value f : factors_of(graph, uses, term.value))
            product.factors.push_back(moved[static_cast<std::size_t>(f)]);
        else
          product.factors.push_back(moved[static_cast<std::size_t>(term.value)]);
        terms.push_back(product);
      }
      target = factoring.build(terms);
    } else {
      target = to.add(node);
    }
    if (!to.is_constant(target) && to[target].op != Op::input) to.set_label(target, graph.label(v));
  }
  for (Port& port : to.outputs)
    for (Value& v : port.values) v = moved[static_cast<std::size_t>(v)];
  return remove_dead(to);
}

}  // namespace sinew

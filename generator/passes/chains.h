// SPDX-License-Identifier: GPL-3.0-or-later
// Sums and products of any length, seen through the two-operand nodes they are stored as.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/graph.h"

namespace sinew {

/// From so many terms on a sum that the derivation named is not opened into another one: its terms
/// repeat one form and become a loop (generator/loops/).
inline constexpr std::size_t terms_of_a_long_sum = 12;

/// A term of a sum: value, and whether it is subtracted.
struct Term {
  Value value;
  bool negative;
};

inline bool is_sum(const Node& n) {
  return n.op == Op::add || n.op == Op::subtract;
}

/// Terms of the sum that ends in `v`, looking through sums used only there.
std::vector<Term> terms_of(const Graph& graph, const std::vector<int>& uses, Value v);

/// Factors of the product that ends in `v`, looking through products used only there.
std::vector<Value> factors_of(const Graph& graph, const std::vector<int>& uses, Value v);

/// True for nodes that are an inner part of a longer sum or product (used once, by the same kind).
std::vector<bool> inner_links(const Graph& graph, const std::vector<int>& uses);

/// Left-to-right sum of the terms, the first positive one leading; negated where all are negative.
Value make_sum(Graph& graph, std::vector<Term> terms);

/// Left-to-right product; the constant 1 where there are no factors.
Value make_product(Graph& graph, const std::vector<Value>& factors);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// One body for computations that have the same form (anti-unification): where they differ in
// constants or input elements the body has a leaf.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "generator/loops/plan.h"

namespace sinew {

/// A number for the form of each value: equal for trees of the same operations, whatever constants
/// and input elements are at their leaves and whatever the order of a commutative operation's
/// operands.
using Forms = std::vector<std::uint64_t>;
Forms forms_of(const Graph& graph);

/// The forms where `leaf` counts as a leaf of its own kind.
Forms forms_given(const Graph& graph, Forms forms, Value leaf);

/// Values that take the same place in all passes, by pass.
using Column = std::vector<Value>;

/// Builds a loop from what it gives in each pass.
class LoopBuilder {
 public:
  LoopBuilder(const Graph& graph, const Forms& forms, int count);

  /// The loop carries `column` from pass to pass and starts with `first`. Every carried column must
  /// be named before `build`.
  void carry(Value first, const Column& column);
  /// The loop stores `column` in these elements of an output.
  void store(const Column& column, int port, const std::vector<int>& elements);

  /// Whether all columns have one form; then `loop` has the body.
  bool build();
  Loop loop;

 private:
  Value unify(const Column& column);
  Value unify_inputs(const Column& column);
  Value unify_operands(const Column& column);
  Value leaf(LoopLeaf leaf);
  bool is_swapped(std::size_t pass, const Node& model, const Node& node) const;
  void set_label(Value made, const Column& column);

  const Graph& graph_;
  std::vector<Column> columns_;    ///< of the results
  std::map<Column, Value> known_;  ///< body's value of a column
  std::vector<Forms> forms_;       ///< by pass: what is carried counts as a leaf
};

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// One body for computations that have the same form (anti-unification): where they differ in
// constants or input elements the body has a leaf. Signs and constant factors are constants that
// may differ, too: a - b is a + (-1) b and x is 1 x, bit for bit.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "generator/loops/plan.h"

namespace sinew {

/// A number for the form of each value: equal for trees of the same operations, whatever constants
/// and input elements are at their leaves, whatever signs and constant factors values have, and
/// whatever the order of a commutative operation's operands.
using Forms = std::vector<std::uint64_t>;

/// Forms of a graph where some values count as leaves, up to the last one that is asked for.
class FormsGiven {
 public:
  explicit FormsGiven(const Forms& forms) : forms_(&forms) {}

  /// `leaf` counts as a leaf of its own kind from here on: what needs it, up to `last`, has another
  /// form.
  void give(const Graph& graph, Value leaf, Value last);

  /// Whether a value needs one of the leaves, or is one.
  bool needs_a_leaf(Value v) const { return changed_.count(static_cast<std::size_t>(v)) > 0; }

  std::uint64_t operator[](std::size_t v) const {
    const auto found = changed_.find(v);
    return found == changed_.end() ? (*forms_)[v] : found->second;
  }

 private:
  const Forms* forms_;
  std::unordered_map<std::size_t, std::uint64_t> changed_;
};

/// The operand that a constant multiplies; no_value for any other operation.
Value scaled_operand(const Graph& graph, const Node& node);

/// Values that take the same place in all passes, by pass.
using Column = std::vector<Value>;

/// Which loop's result has a value, and in which pass.
struct KeptPlace {
  int array = 0;
  int pass = 0;
};
using KeptValues = std::map<Value, KeptPlace>;

/// What a loop kept counts as input elements of one array.
Forms forms_of(const Graph& graph, const KeptValues& kept);
/// The same where signs and constant factors make another form: what has one form then needs no
/// operation more in a loop than outside.
Forms exact_forms_of(const Graph& graph, const KeptValues& kept);

/// Builds a loop from what it gives in each pass.
class LoopBuilder {
 public:
  /// `read` are values that are there whatever this loop does.
  LoopBuilder(const Graph& graph, const Forms& forms, const KeptValues& kept,
              const std::set<Value>& read, int count);

  /// The loop carries `column` from pass to pass and starts with `first`. Every carried column must
  /// be named before `build`.
  void carry(Value first, const Column& column);
  /// The loop stores `column` in these elements of an output.
  void store(const Column& column, int port, const std::vector<int>& elements);

  /// The loop keeps `column`.
  void keep(const Column& column);

  /// Whether all columns have one form; then `loop` has the body.
  bool build();
  /// Of a loop that is built: keeps these columns of its body and no others.
  void keep_only(const std::set<Column>& columns);
  /// The columns of the body's values that are operations.
  std::map<Value, Column> columns() const;
  Loop loop;

 private:
  using Scales = std::vector<double>;  ///< factors, by pass
  struct Term {
    Value value = no_value;
    bool negative = false;
  };

  void set_forms();
  Value unify(const Column& column);
  Value make(const Column& column);
  Value unify_inputs(const Column& column);
  Value unify_operands(const Column& column);
  Term unify_term(const Column& column, const Scales& signs);
  Term signed_product(const Column& column, const Scales& signs);
  Term signed_value(const Column& column, Scales signs);
  Value make_sum(const std::array<Column, 3>& operands, const std::array<Scales, 3>& signs);
  Value make_node(const Node& model, const std::array<Column, 3>& operands);
  bool is_kept(const Column& column) const;
  bool is_choice(const Column& column) const;
  Value chosen(const Column& column);
  Scales taken_out(Column& column) const;
  Value scaled(const Scales& scales, Value base);
  Value constants(Scales signs, const Column& column);
  Value leaf(LoopLeaf leaf);
  Value leaf_of(const Scales& scales);
  bool is_carried(std::size_t pass, Value v) const;
  bool is_swapped(std::size_t pass, const Node& model, const Node& node) const;
  void set_label(Value made, const Column& column);

  const Graph& graph_;
  const KeptValues& kept_;
  const std::set<Value>& read_;
  std::vector<Column> columns_;                            ///< of the results
  std::vector<Column> entries_;                            ///< what is carried into each pass
  std::map<Column, Value> known_;                          ///< body's value of a column
  std::map<std::pair<Column, Scales>, Term> known_terms_;  ///< of columns with signs that differ
  std::map<Scales, Value> tables_;
  std::vector<FormsGiven> forms_;  ///< by pass: what is carried counts as a leaf
};

}  // namespace sinew

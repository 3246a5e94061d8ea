// SPDX-License-Identifier: GPL-3.0-or-later
// The generator's own form of a function: flat, value-numbered, index-based.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/range.h"

namespace sinew {

enum class Op : std::uint8_t {
  input,
  constant,
  add,
  subtract,
  multiply,
  divide,
  negate,
  power,  ///< a^exponent, integer exponent >= 2; the pass `powers` removes it
  square_root,
  sine,
  cosine,
  arctangent,
  arctangent2,  ///< a = y, b = x
  arccosine,
  arcsine,
  exponential,
  logarithm,
  hyperbolic_tangent,
  absolute,
  minimum,
  maximum,
  choose,  ///< a >= 0 ? b : c
  // Rounded once; only for targets with fused multiply-add (the pass fuse makes them).
  multiply_add,       ///< a * b + c
  multiply_subtract,  ///< a * b - c
  subtract_product,   ///< c - a * b
};

/// Number of operands of an operation.
int arity(Op op);
/// Lower-case name, as in dumps.
const char* name_of(Op op);
/// True where a op b == b op a, bit for bit.
bool is_commutative(Op op);

/// Index of a node.
using Value = std::int32_t;
inline constexpr Value no_value = -1;

struct Node {
  Op op = Op::constant;
  Value a = no_value;
  Value b = no_value;
  Value c = no_value;
  std::int32_t index = 0;  ///< input: position among all input elements; power: the exponent
  double constant = 0.0;

  Value operand(int i) const { return i == 0 ? a : i == 1 ? b : c; }
  Value& operand(int i) { return i == 0 ? a : i == 1 ? b : c; }
};

/// One array argument or result; row-major.
struct Port {
  std::string name;
  int rows = 1;
  int cols = 1;
  std::string unit;
  std::string doc;
  std::vector<Range> ranges;  ///< inputs only
  /// Outputs: rows*cols. Inputs: what must be computed before an element is read, the numbers that
  /// are passed to the call that fills the array (generator/calls).
  std::vector<Value> values;
  std::vector<double> reference = {};    ///< inputs only, as in Argument
  bool by_value = false;                 ///< inputs only, as in Argument
  std::vector<std::string> states = {};  ///< outputs only, as in Output
  int size() const { return rows * cols; }
};

/// A function as a list of operations, operands always before their users.
/// Equal operations on equal operands have one node (value numbering).
class Graph {
 public:
  std::string name;
  std::string doc;
  std::string equation;
  std::vector<Port> inputs;
  std::vector<Port> outputs;
  std::vector<std::string> chain = {};  ///< as in Function

  const std::vector<Node>& nodes() const { return nodes_; }
  const Node& operator[](Value v) const { return nodes_[static_cast<std::size_t>(v)]; }
  Value size() const { return static_cast<Value>(nodes_.size()); }

  /// The value of `node`, new or already there. No simplification.
  Value add(const Node& node);
  Value constant(double value);
  Value input(int index);
  Value make(Op op, Value a, Value b = no_value, Value c = no_value);

  /// The derivation's name of a value; empty where it has none.
  const std::string& label(Value v) const { return labels_[static_cast<std::size_t>(v)]; }
  void set_label(Value v, const std::string& label);

  bool is_constant(Value v) const { return (*this)[v].op == Op::constant; }
  bool is_constant(Value v, double value) const;

  /// The value of `node` where it is there, else no_value.
  Value find(const Node& node) const;
  /// The argument that an input element belongs to.
  std::size_t port_of_input(int index) const;

  /// Number of input elements over all arguments.
  int input_size() const;
  /// Name of an input element as the emitted C writes it, for instance "q[2]".
  std::string input_name(int index) const;
  /// All output values, one after the other.
  std::vector<Value> results() const;

  /// A graph with the same signature and no nodes.
  Graph empty_like() const;

 private:
  /// Where the node's value stands in the table, or the free place for it.
  std::size_t place_of(const Node& node) const;
  void grow_table();

  std::vector<Node> nodes_;
  std::vector<std::string> labels_;
  std::vector<Value> table_;  ///< value numbers by hash of their node; no_value where free
};

/// How often each node is used as an operand, result, or number passed to a call.
std::vector<int> use_counts(const Graph& graph);

}  // namespace sinew

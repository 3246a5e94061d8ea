// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace sinew {
namespace {

struct OpFacts {
  const char* name;
  int arity;
  bool commutative;
};

constexpr std::array<OpFacts, 25> op_facts{{
    {"input", 0, false},   {"constant", 0, false}, {"add", 2, true},     {"subtract", 2, false},
    {"multiply", 2, true}, {"divide", 2, false},   {"negate", 1, false}, {"power", 1, false},
    {"sqrt", 1, false},    {"sin", 1, false},      {"cos", 1, false},    {"atan", 1, false},
    {"atan2", 2, false},   {"acos", 1, false},     {"asin", 1, false},   {"exp", 1, false},
    {"log", 1, false},     {"tanh", 1, false},     {"abs", 1, false},    {"min", 2, false},
    {"max", 2, false},     {"choose", 3, false},   {"fma", 3, false},    {"fms", 3, false},
    {"fnma", 3, false},
}};

const OpFacts& facts(Op op) {
  return op_facts[static_cast<std::size_t>(op)];
}

std::uint64_t mix(std::uint64_t h, std::uint64_t x) {
  h ^= x + 0x9e3779b97f4a7c15ULL + (h << 6) + (h >> 2);
  return h * 0xff51afd7ed558ccdULL;
}

bool same(const Node& x, const Node& y) {
  if (x.op != y.op || x.index != y.index || x.c != y.c ||
      std::bit_cast<std::uint64_t>(x.constant) != std::bit_cast<std::uint64_t>(y.constant))
    return false;
  if (x.a == y.a && x.b == y.b) return true;
  return is_commutative(x.op) && x.a == y.b && x.b == y.a;
}

std::uint64_t key(const Node& node) {
  Value a = node.a, b = node.b;
  if (is_commutative(node.op) && b < a) std::swap(a, b);
  std::uint64_t h = static_cast<std::uint64_t>(node.op);
  h = mix(h, static_cast<std::uint64_t>(a) + 7);
  h = mix(h, static_cast<std::uint64_t>(b) + 11);
  h = mix(h, static_cast<std::uint64_t>(node.c) + 13);
  h = mix(h, static_cast<std::uint64_t>(node.index));
  h = mix(h, std::bit_cast<std::uint64_t>(node.constant));
  return h ^ (h >> 32);  // the table looks at the low bits
}

}  // namespace

int arity(Op op) {
  return facts(op).arity;
}
const char* name_of(Op op) {
  return facts(op).name;
}
bool is_commutative(Op op) {
  return facts(op).commutative;
}

// One flat table with linear probing: every pass fills a new graph, and a bucket a node would make
// allocation the longest part of generating.
std::size_t Graph::place_of(const Node& node) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t place = static_cast<std::size_t>(key(node)) & mask;
  while (table_[place] != no_value && !same((*this)[table_[place]], node))
    place = (place + 1) & mask;
  return place;
}

void Graph::grow_table() {
  table_.assign(std::max<std::size_t>(64, 4 * table_.size()), no_value);
  for (Value v = 0; v < size(); ++v) table_[place_of((*this)[v])] = v;
}

Value Graph::add(const Node& node) {
  if (2 * nodes_.size() >= table_.size()) grow_table();
  const std::size_t place = place_of(node);
  if (table_[place] != no_value) return table_[place];
  nodes_.push_back(node);
  labels_.emplace_back();
  return table_[place] = size() - 1;
}

Value Graph::constant(double value) {
  Node node;
  node.constant = value == 0.0 ? 0.0 : value;  // no negative zero among the constants
  return add(node);
}

Value Graph::input(int index) {
  Node node;
  node.op = Op::input;
  node.index = index;
  return add(node);
}

Value Graph::make(Op op, Value a, Value b, Value c) {
  Node node;
  node.op = op;
  node.a = a;
  node.b = b;
  node.c = c;
  return add(node);
}

void Graph::set_label(Value v, const std::string& label) {
  std::string& mine = labels_[static_cast<std::size_t>(v)];
  if (mine.empty()) mine = label;
}

bool Graph::is_constant(Value v, double value) const {
  return is_constant(v) && (*this)[v].constant == value;
}

Value Graph::find(const Node& node) const {
  return table_.empty() ? no_value : table_[place_of(node)];
}

std::size_t Graph::port_of_input(int index) const {
  std::size_t port = 0;
  while (index >= inputs[port].size()) index -= inputs[port++].size();
  return port;
}

int Graph::input_size() const {
  int total = 0;
  for (const Port& port : inputs) total += port.size();
  return total;
}

std::string Graph::input_name(int index) const {
  for (const Port& port : inputs) {
    if (index < port.size()) return fmt::format("{}[{}]", port.name, index);
    index -= port.size();
  }
  return "?";
}

std::vector<Value> Graph::results() const {
  std::vector<Value> all;
  for (const Port& port : outputs) all.insert(all.end(), port.values.begin(), port.values.end());
  return all;
}

Graph Graph::empty_like() const {
  Graph copy;
  copy.name = name;
  copy.doc = doc;
  copy.equation = equation;
  copy.inputs = inputs;
  copy.outputs = outputs;
  return copy;
}

std::vector<int> use_counts(const Graph& graph) {
  std::vector<int> uses(static_cast<std::size_t>(graph.size()), 0);
  for (const Node& node : graph.nodes())
    for (int i = 0; i < arity(node.op); ++i) ++uses[static_cast<std::size_t>(node.operand(i))];
  for (Value v : graph.results()) ++uses[static_cast<std::size_t>(v)];
  for (const Port& port : graph.inputs)
    for (Value v : port.values) ++uses[static_cast<std::size_t>(v)];
  return uses;
}

}  // namespace sinew

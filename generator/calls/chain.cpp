// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/calls/chain.h"

#include <map>
#include <stdexcept>

namespace sinew {
namespace {

/// Elements of an array by its name.
using Arrays = std::map<std::string, std::vector<Value>>;

[[noreturn]] void refuse(const Graph& chain, const std::string& what) {
  throw std::invalid_argument(chain.name + ": as a chain of functions, " + what);
}

const std::vector<Value>& array_of(const Arrays& arrays, const Port& port, const Graph& chain) {
  const auto found = arrays.find(port.name);
  if (found == arrays.end() || found->second.size() != static_cast<std::size_t>(port.size()))
    refuse(chain, "it has no " + port.name + " of that size");
  return found->second;
}

/// Appends a function's operations to `joined`, and its results to `arrays`.
void append(Graph& joined, Arrays& arrays, const Graph& function) {
  std::vector<Value> inputs, copy;
  for (const Port& port : function.inputs) {
    const std::vector<Value>& given = array_of(arrays, port, joined);
    inputs.insert(inputs.end(), given.begin(), given.end());
  }
  for (Value v = 0; v < function.size(); ++v) {
    Node node = function[v];
    if (node.op == Op::input) {
      copy.push_back(inputs[static_cast<std::size_t>(node.index)]);
      continue;
    }
    for (int i = 0; i < arity(node.op); ++i)
      node.operand(i) = copy[static_cast<std::size_t>(node.operand(i))];
    copy.push_back(joined.add(node));
    joined.set_label(copy.back(), function.label(v));
  }
  for (const Port& port : function.outputs) {
    std::vector<Value> values;
    for (const Value v : port.values) values.push_back(copy[static_cast<std::size_t>(v)]);
    if (!arrays.try_emplace(port.name, values).second)
      refuse(joined, "it has two arrays named " + port.name);
  }
}

Graph joined(const std::vector<Graph>& functions, const Graph& chain) {
  Graph result = chain.empty_like();
  result.chain = chain.chain;
  Arrays arrays;
  int index = 0;
  for (const Port& port : result.inputs)
    for (int i = 0; i < port.size(); ++i) arrays[port.name].push_back(result.input(index++));
  for (const std::string& name : chain.chain)
    append(result, arrays, functions[place_of_function(functions, name)]);
  for (Port& port : result.outputs) port.values = array_of(arrays, port, result);
  const std::vector<Port>& last =
      functions[place_of_function(functions, chain.chain.back())].outputs;
  if (last.size() != result.outputs.size()) refuse(chain, "it does not end with its results");
  for (std::size_t p = 0; p < last.size(); ++p)
    if (last[p].name != result.outputs[p].name) refuse(chain, "it does not end with its results");
  return result;
}

}  // namespace

std::size_t place_of_function(const std::vector<Graph>& functions, const std::string& name) {
  for (std::size_t i = 0; i < functions.size(); ++i)
    if (functions[i].name == name) return i;
  throw std::invalid_argument("there is no function " + name);
}

void join_chains(std::vector<Graph>& functions) {
  for (Graph& function : functions)
    if (!function.chain.empty()) function = joined(functions, function);
}

}  // namespace sinew

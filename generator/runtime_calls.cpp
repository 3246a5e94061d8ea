// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/runtime_calls.h"

#include <fmt/format.h>

#include <map>

namespace sinew {
namespace {

/// Runtime functions of many instructions; sine and cosine are one of their own.
bool is_large(Op op) {
  return op == Op::arctangent || op == Op::arctangent2 || op == Op::arccosine ||
         op == Op::arcsine || op == Op::exponential || op == Op::logarithm ||
         op == Op::hyperbolic_tangent;
}

}  // namespace

const char* runtime_function(Op op) {
  switch (op) {
    case Op::square_root:
      return "sinew_sqrt";
    case Op::arctangent:
      return "sinew_atan";
    case Op::arctangent2:
      return "sinew_atan2";
    case Op::arccosine:
      return "sinew_acos";
    case Op::arcsine:
      return "sinew_asin";
    case Op::exponential:
      return "sinew_exp";
    case Op::logarithm:
      return "sinew_log";
    case Op::hyperbolic_tangent:
      return "sinew_tanh";
    case Op::absolute:
      return "sinew_abs";
    case Op::minimum:
      return "sinew_min";
    case Op::maximum:
      return "sinew_max";
    case Op::choose:
      return "sinew_choose";
    default:
      return nullptr;
  }
}

std::string shared_name(Op op, const Target& target) {
  if (op == Op::sine || op == Op::cosine) return fmt::format("sinew_one_sincos{}", target.suffix());
  if (!is_large(op)) return "";
  return "sinew_one_" + std::string(runtime_function(op)).substr(std::string("sinew_").size()) +
         target.suffix();
}

std::vector<SharedFunction> shared_functions(const std::vector<Graph>& graphs,
                                             const Target& target) {
  const std::string real = target.type(), suffix = target.suffix();
  std::map<std::string, SharedFunction> found;
  std::map<std::string, int> calls;
  for (const Graph& graph : graphs)
    for (const Node& node : graph.nodes()) {
      const std::string name = shared_name(node.op, target);
      const bool angle = node.op == Op::sine || node.op == Op::cosine;
      if (name.empty() || (angle && target.optimise != Optimise::size)) continue;
      const std::string function = angle ? "sinew_sincos" : runtime_function(node.op);
      const std::string parameters = angle                 ? "{0} x, {0} *s, {0} *c"
                                     : arity(node.op) == 2 ? "{0} y, {0} x"
                                                           : "{0} x";
      const std::string arguments = angle ? "x, s, c" : arity(node.op) == 2 ? "y, x" : "x";
      ++calls[name];
      found[name] = {
          name,
          fmt::format("SINEW_NOT_INLINE static {} {}({})\n{{\n    {}{}{}({});\n}}\n",
                      angle ? "void" : real, name, fmt::format(fmt::runtime(parameters), real),
                      angle ? "" : "return ", function, suffix, arguments)};
    }
  std::vector<SharedFunction> all;
  for (const auto& [name, function] : found)
    if (calls[name] > 1 || target.optimise == Optimise::size) all.push_back(function);
  return all;
}

}  // namespace sinew

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

SharedFunction shared_copy(Op op, const Target& target) {
  const std::string name = shared_name(op, target);
  const std::string parameters =
      fmt::format(fmt::runtime(arity(op) == 2 ? "{0} y, {0} x" : "{0} x"), target.type());
  return {
      name,
      fmt::format("static {} {}({})\n{{\n    return {}{}({});\n}}\n", target.type(), name,
                  parameters, runtime_function(op), target.suffix(), arity(op) == 2 ? "y, x" : "x"),
      ""};
}

/// By value: where the machine passes small structures in registers nothing is stored.
SharedFunction shared_sincos(std::size_t angles, const Target& target) {
  const std::string name = shared_sincos_name(angles, target), type = shared_sincos_type(angles);
  const std::string parameters = angles == 1 ? "{0} x" : "{0} x0, {0} x1";
  const std::string call =
      angles == 1 ? fmt::format("sinew_sincos{}(x, y.s, y.c);", target.suffix())
                  : fmt::format("const {} x[2] = {{x0, x1}};\n    sinew_sincos2{}(x, y.s, y.c);",
                                target.type(), target.suffix());
  return {name,
          fmt::format("static {} {}({})\n{{\n    {} y;\n    {}\n    return y;\n}}\n", type, name,
                      fmt::format(fmt::runtime(parameters), target.type()), type, call),
          fmt::format("{} {{\n    {} s[{}], c[{}];\n}};\n", type, target.type(), angles, angles)};
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
  if (op == Op::sine || op == Op::cosine) return shared_sincos_name(1, target);
  if (!is_large(op)) return "";
  return "sinew_one_" + std::string(runtime_function(op)).substr(std::string("sinew_").size()) +
         target.suffix();
}

std::string shared_sincos_name(std::size_t angles, const Target& target) {
  return fmt::format("sinew_one_sincos{}{}", angles == 1 ? "" : std::to_string(angles),
                     target.suffix());
}

std::string shared_sincos_type(std::size_t angles) {
  return fmt::format("struct sinew_sines{}", angles == 1 ? "" : std::to_string(angles));
}

std::vector<SharedFunction> shared_functions(const std::vector<Graph>& graphs,
                                             const Target& target) {
  std::map<std::string, SharedFunction> found;
  for (const Graph& graph : graphs)
    for (const Node& node : graph.nodes()) {
      if (shared_name(node.op, target).empty()) continue;
      if (node.op != Op::sine && node.op != Op::cosine)
        found[shared_name(node.op, target)] = shared_copy(node.op, target);
      else
        for (std::size_t angles : {1u, 2u})
          if (angles == 1 || target.optimise == Optimise::speed)
            found[shared_sincos_name(angles, target)] = shared_sincos(angles, target);
    }
  std::vector<SharedFunction> all;
  for (const auto& [name, function] : found) all.push_back(function);
  return all;
}

}  // namespace sinew

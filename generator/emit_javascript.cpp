// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emit_javascript.h"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "generator/literal.h"

namespace sinew {
namespace {

constexpr std::size_t longest_javascript = 120;

/// Written in a language whose operators bind as C's do: + - below * / below unary -.
enum Tightness { ties_sum = 1, ties_product = 2, ties_unary = 3, ties_atom = 4 };

struct Written {
  std::string text;
  Tightness tightness = ties_atom;
};

/// The function of the language, or of the prelude, that an operation is; nullptr for operators.
const char* function_of(Op op) {
  switch (op) {
    case Op::square_root:
      return "root";
    case Op::sine:
      return "Math.sin";
    case Op::cosine:
      return "Math.cos";
    case Op::arctangent:
      return "Math.atan";
    case Op::arctangent2:
      return "Math.atan2";
    case Op::arccosine:
      return "arccosine";
    case Op::arcsine:
      return "arcsine";
    case Op::exponential:
      return "exponential";
    case Op::logarithm:
      return "logarithm";
    case Op::hyperbolic_tangent:
      return "Math.tanh";
    case Op::absolute:
      return "Math.abs";
    case Op::minimum:
      return "smaller";
    case Op::maximum:
      return "larger";
    case Op::choose:
      return "choose";
    default:
      return nullptr;
  }
}

class JavascriptWriter {
 public:
  explicit JavascriptWriter(const Graph& graph)
      : graph_(graph), uses_(use_counts(graph)), written_(static_cast<std::size_t>(graph.size())) {}

  std::string run() {
    for (Value v = 0; v < graph_.size(); ++v)
      if (uses_[static_cast<std::size_t>(v)] > 0) write(v);
    std::string results;
    for (const Value v : graph_.results()) results += (results.empty() ? "" : ",") + at(v).text;
    return "function (x) {\n" + lines_ + "return [" + results + "];\n}";
  }

 private:
  Written& at(Value v) { return written_[static_cast<std::size_t>(v)]; }

  void write(Value v) {
    const Node& node = graph_[v];
    Written expression = form(node);
    const bool is_given = node.op == Op::input || node.op == Op::constant;
    if (!is_given &&
        (uses_[static_cast<std::size_t>(v)] > 1 || expression.text.size() > longest_javascript)) {
      const std::string name = fmt::format("t{}", v);
      lines_ += fmt::format("const {}={};\n", name, expression.text);
      expression = {name, ties_atom};
    }
    at(v) = expression;
  }

  Written form(const Node& node) {
    switch (node.op) {
      case Op::input:
        return {fmt::format("x[{}]", node.index), ties_atom};
      case Op::constant:
        return {literal(node.constant, Target{}), node.constant < 0 ? ties_unary : ties_atom};
      case Op::add:
        return infix(node, "+", ties_sum);
      case Op::subtract:
        return infix(node, "-", ties_sum);
      case Op::multiply:
        return infix(node, "*", ties_product);
      case Op::divide:
        return infix(node, "/", ties_product);
      case Op::negate:
        return {"-" + inside(node.a, ties_atom), ties_unary};
      case Op::power:
        return repeated(node);
      case Op::multiply_add:
      case Op::multiply_subtract:
      case Op::subtract_product:
        throw std::invalid_argument("function " + graph_.name +
                                    ": JavaScript has no fused multiply-add");
      default:
        return call(node);
    }
  }

  /// Spaces keep a sign apart from the one before it: a- -b.
  Written infix(const Node& node, const char* sign, Tightness tightness) {
    std::string right = inside(node.b, static_cast<Tightness>(tightness + 1));
    if (right.front() == '-') right = " " + right;
    return {inside(node.a, tightness) + sign + right, tightness};
  }

  Written repeated(const Node& node) {
    std::string text = inside(node.a, ties_product);
    for (int i = 1; i < node.index; ++i) text += "*" + inside(node.a, ties_atom);
    return {text, ties_product};
  }

  Written call(const Node& node) {
    std::string arguments;
    for (int i = 0; i < arity(node.op); ++i)
      arguments += (i > 0 ? "," : "") + at(node.operand(i)).text;
    return {fmt::format("{}({})", function_of(node.op), arguments), ties_atom};
  }

  std::string inside(Value v, Tightness least) {
    const Written& w = at(v);
    return w.tightness >= least ? w.text : "(" + w.text + ")";
  }

  const Graph& graph_;
  std::vector<int> uses_;
  std::vector<Written> written_;
  std::string lines_;
};

}  // namespace

std::string emit_javascript(const Graph& graph) {
  return JavascriptWriter(graph).run();
}

std::string javascript_prelude() {
  return "const root = x => x >= 0 && x < Infinity ? Math.sqrt(x) : 0;\n"
         "const arccosine = x => Math.acos(Math.max(-1, Math.min(1, x)));\n"
         "const arcsine = x => Math.asin(Math.max(-1, Math.min(1, x)));\n"
         "const exponential = x => Math.exp(Math.max(-708, Math.min(708, x)));\n"
         "const logarithm = x => Math.log(Math.max(2.2250738585072014e-308, x));\n"
         "const smaller = (a, b) => a < b ? a : b;\n"
         "const larger = (a, b) => a > b ? a : b;\n"
         "const choose = (condition, a, b) => condition >= 0 ? a : b;\n";
}

}  // namespace sinew

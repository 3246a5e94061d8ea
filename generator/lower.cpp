// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/lower.h"

#include <cln/cln.h>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

/// A value with its sign kept apart, so that signs can be moved to where they cost nothing.
struct Signed {
  Value value;
  bool negative = false;
};

const std::map<std::string, Op>& operations_by_name() {
  static const std::map<std::string, Op> table{
      {"sin", Op::sine},          {"cos", Op::cosine},      {"atan", Op::arctangent},
      {"atan2", Op::arctangent2}, {"acos", Op::arccosine},  {"asin", Op::arcsine},
      {"exp", Op::exponential},   {"log", Op::logarithm},   {"tanh", Op::hyperbolic_tangent},
      {"abs", Op::absolute},      {"minimum", Op::minimum}, {"maximum", Op::maximum},
      {"choose", Op::choose}};
  return table;
}

double nearest_double(const GiNaC::numeric& number) {
  return cln::double_approx(cln::the<cln::cl_R>(number.to_cl_N()));
}

class Lowering {
 public:
  explicit Lowering(const Function& function) : function_(function) {}

  Graph run() {
    describe();
    for (const Definition& definition : function_.definitions) define(definition);
    for (std::size_t i = 0; i < function_.outputs.size(); ++i)
      for (const ex& value : function_.outputs[i].values)
        graph_.outputs[i].values.push_back(positive(lower(value)));
    return std::move(graph_);
  }

 private:
  void describe() {
    graph_.name = function_.name;
    graph_.doc = function_.doc;
    graph_.equation = function_.equation;
    int next = 0;
    for (const Argument& argument : function_.inputs) {
      graph_.inputs.push_back({argument.name,
                               argument.rows,
                               argument.cols,
                               argument.unit,
                               argument.doc,
                               argument.ranges,
                               {},
                               argument.reference,
                               argument.by_value});
      if (argument.by_value && argument.rows * argument.cols != 1)
        fail(fmt::format("argument {} is {}x{} and by value", argument.name, argument.rows,
                         argument.cols));
      if (static_cast<int>(argument.symbols.size()) != argument.rows * argument.cols)
        fail(fmt::format("argument {} has {} symbols for {}x{}", argument.name,
                         argument.symbols.size(), argument.rows, argument.cols));
      for (const GiNaC::symbol& symbol : argument.symbols)
        symbols_[symbol] = {graph_.input(next++), false};
    }
    for (const Output& output : function_.outputs) {
      graph_.outputs.push_back({output.name,
                                output.rows,
                                output.cols,
                                output.unit,
                                output.doc,
                                {},
                                {},
                                {},
                                false,
                                output.states});
      if (!output.states.empty() && output.rows * output.cols != 1)
        fail(fmt::format("status {} is {}x{}", output.name, output.rows, output.cols));
      if (static_cast<int>(output.values.size()) != output.rows * output.cols)
        fail(fmt::format("result {} has {} values for {}x{}", output.name, output.values.size(),
                         output.rows, output.cols));
    }
  }

  void define(const Definition& definition) {
    const Signed value = lower(definition.value);
    symbols_[definition.symbol] = value;
    graph_.set_label(value.value, definition.symbol.get_name());
    rank_.emplace(value.value, static_cast<int>(rank_.size()));
  }

  Signed lower(const ex& e) {
    if (is_a<GiNaC::numeric>(e)) {
      if (!ex_to<GiNaC::numeric>(e).is_real())
        fail_expression("a complex number has no C form:", e);
      return number(ex_to<GiNaC::numeric>(e));
    }
    if (is_a<GiNaC::symbol>(e)) return symbol(e);
    if (is_a<GiNaC::add>(e)) return sum(e);
    if (is_a<GiNaC::mul>(e)) return product(e);
    if (is_a<GiNaC::power>(e)) return power(e.op(0), e.op(1));
    if (is_a<GiNaC::constant>(e)) return number(ex_to<GiNaC::numeric>(e.evalf()));
    if (is_a<GiNaC::function>(e)) return call(e);
    fail_expression("no C form for", e);
  }

  Signed number(const GiNaC::numeric& n) {
    const double value = nearest_double(n);
    return {graph_.constant(value < 0 ? -value : value), value < 0};
  }

  Signed symbol(const ex& e) {
    const auto found = symbols_.find(e);
    if (found == symbols_.end())
      fail_expression("symbol is neither input nor earlier definition:", e);
    return found->second;
  }

  Signed sum(const ex& e) {
    std::vector<Signed> terms;
    for (std::size_t i = 0; i < e.nops(); ++i) terms.push_back(lower(e.op(i)));
    sort(terms);
    const bool flip = terms.front().negative;
    Value total = terms.front().value;
    for (std::size_t i = 1; i < terms.size(); ++i)
      total = terms[i].negative == flip ? in_order(Op::add, total, terms[i].value)
                                        : graph_.make(Op::subtract, total, terms[i].value);
    return {total, flip};
  }

  Signed product(const ex& e) {
    std::vector<Signed> above, below;
    GiNaC::numeric constant = 1;
    for (std::size_t i = 0; i < e.nops(); ++i) {
      const ex factor = e.op(i);
      if (is_a<GiNaC::power>(factor) && is_negative_number(factor.op(1))) {
        const Denominator denominator = reduced(factor.op(0), -factor.op(1));
        constant = constant / denominator.taken_out;
        below.push_back(power(denominator.base, -factor.op(1)));
      } else if (is_a<GiNaC::numeric>(factor)) {
        constant = constant * ex_to<GiNaC::numeric>(factor);
      } else {
        above.push_back(lower(factor));
      }
    }
    if (!constant.is_equal(1)) above.push_back(lower(constant));
    if (above.empty()) above.push_back({graph_.constant(1.0), false});
    const Signed numerator = multiply(above);
    if (below.empty()) return numerator;
    const Signed denominator = multiply(below);
    return {graph_.make(Op::divide, numerator.value, denominator.value),
            numerator.negative != denominator.negative};
  }

  Signed multiply(std::vector<Signed>& factors) {
    sort(factors);
    Signed result{no_value, false};
    for (const Signed& factor : factors) {
      result.negative = result.negative != factor.negative;
      // a bare sign is no factor: 1*x must be the very node x, or terms would sort by their sign
      if (graph_.is_constant(factor.value, 1.0)) continue;
      result.value = result.value == no_value ? factor.value
                                              : in_order(Op::multiply, result.value, factor.value);
    }
    if (result.value == no_value) result.value = graph_.constant(1.0);
    return result;
  }

  static bool is_negative_number(const ex& e) {
    return is_a<GiNaC::numeric>(e) && ex_to<GiNaC::numeric>(e).is_negative();
  }

  /// A denominator is base^n times `taken_out`.
  struct Denominator {
    ex base;
    GiNaC::numeric taken_out = 1;
  };

  /// GiNaC clears fractions from sums in denominators, which may leave integers that no float
  /// holds: 1e43/(1e43 x + 6e36) instead of 1/(x + 6e-7). The largest is taken out.
  static Denominator reduced(const ex& base, const ex& exponent) {
    if (!is_a<GiNaC::add>(base) || !exponent.info(GiNaC::info_flags::posint)) return {base};
    static const GiNaC::numeric too_large("1000000000000000");
    GiNaC::numeric largest = 0;
    for (std::size_t i = 0; i < base.nops(); ++i) {
      const ex term = base.op(i);
      const ex number = is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : term;
      if (!is_a<GiNaC::numeric>(number) || !ex_to<GiNaC::numeric>(number).is_real()) continue;
      largest = std::max(largest, GiNaC::abs(ex_to<GiNaC::numeric>(number)));
    }
    if (largest < too_large) return {base};
    return {(base / largest).expand(), largest.power(ex_to<GiNaC::numeric>(exponent))};
  }

  Signed power(const ex& base, const ex& exponent) {
    if (!is_a<GiNaC::numeric>(exponent)) fail_expression("exponent is not a number:", exponent);
    GiNaC::numeric n = ex_to<GiNaC::numeric>(exponent);
    if (n.is_negative()) {
      const Denominator denominator = reduced(base, -n);
      const Signed below = power(denominator.base, -n);
      const Signed above = number(denominator.taken_out.inverse());
      return {graph_.make(Op::divide, above.value, below.value), below.negative != above.negative};
    }
    Signed root = lower(base);
    if (!n.is_integer()) {
      n = n * GiNaC::numeric(2);
      if (!n.is_integer())
        fail_expression("only integer and half-integer powers have a C form:", exponent);
      root = {graph_.make(Op::square_root, positive(root)), false};
    }
    const int count = n.to_int();
    if (count == 1) return root;
    Node node;
    node.op = Op::power;
    node.a = root.value;
    node.index = count;
    return {graph_.add(node), root.negative && count % 2 == 1};
  }

  Signed call(const ex& e) {
    const std::string name = ex_to<GiNaC::function>(e).get_name();
    const auto found = operations_by_name().find(name);
    if (found == operations_by_name().end()) fail_expression("function has no C form:", e);
    const Op op = found->second;
    std::vector<Signed> operands;
    for (std::size_t i = 0; i < e.nops(); ++i) operands.push_back(lower(e.op(i)));
    const bool odd =
        op == Op::sine || op == Op::arctangent || op == Op::arcsine || op == Op::hyperbolic_tangent;
    const bool even = op == Op::cosine || op == Op::absolute;
    if (odd || even)  // odd and even functions pass the sign on or drop it
      return {graph_.make(op, operands[0].value), odd && operands[0].negative};
    Value v[3] = {no_value, no_value, no_value};
    for (std::size_t i = 0; i < operands.size() && i < 3; ++i) v[i] = positive(operands[i]);
    return {graph_.make(op, v[0], v[1], v[2]), false};
  }

  Value positive(Signed s) {
    if (!s.negative) return s.value;
    if (graph_.is_constant(s.value)) return graph_.constant(-graph_[s.value].constant);
    return graph_.make(Op::negate, s.value);
  }

  void sort(std::vector<Signed>& operands) const {
    std::sort(operands.begin(), operands.end(), [this](const Signed& x, const Signed& y) {
      const int order = compare(x.value, y.value);
      return order != 0 ? order < 0 : x.negative < y.negative;
    });
  }

  /// x op y or y op x: one node, which may be met from both sides, for instance (a + b) + c from
  /// a + b + c and from c + d with a definition d = a + b. The order must not be that of the first
  /// visit, which GiNaC decides: an unnamed part of a longer sum or product leads, then the lesser.
  Value in_order(Op op, Value x, Value y) {
    const auto leads = [&](Value v) { return same_chain(op, graph_[v].op) && !rank_.count(v); };
    const bool swap = leads(x) == leads(y) ? compare(y, x) < 0 : leads(y);
    return swap ? graph_.make(op, y, x) : graph_.make(op, x, y);
  }

  static bool same_chain(Op op, Op inner) {
    return inner == op || (op == Op::add && inner == Op::subtract);
  }

  /// Total order by structure: constants, inputs, definitions in their order, then operations.
  int compare(Value x, Value y) const {
    if (x == y) return 0;
    const auto category = [this](Value v) {
      if (graph_.is_constant(v)) return 0;
      if (graph_[v].op == Op::input) return 1;
      return rank_.count(v) ? 2 : 3;
    };
    const int cx = category(x), cy = category(y);
    if (cx != cy) return cx - cy;
    if (cx == 0) return graph_[x].constant < graph_[y].constant ? -1 : 1;
    if (cx == 1) return graph_[x].index - graph_[y].index;
    if (cx == 2) return rank_.at(x) - rank_.at(y);
    return compare_operations(graph_[x], graph_[y]);
  }

  int compare_operations(const Node& x, const Node& y) const {
    if (x.op != y.op) return static_cast<int>(x.op) - static_cast<int>(y.op);
    if (x.index != y.index) return x.index - y.index;
    for (int i = 0; i < arity(x.op); ++i)
      if (const int order = compare(x.operand(i), y.operand(i))) return order;
    return 0;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(fmt::format("function {}: {}", function_.name, what));
  }
  [[noreturn]] void fail_expression(const std::string& what, const ex& e) const {
    std::ostringstream text;
    text << e;
    fail(what + " " + text.str());
  }

  const Function& function_;
  Graph graph_;
  std::map<ex, Signed, GiNaC::ex_is_less> symbols_;
  std::map<Value, int> rank_;
};

/// Rebuilds the graph in depth-first order from the definitions' labels and results, so that node
/// numbers no longer depend on the order in which GiNaC handed out operands.
Graph renumber(const Graph& from) {
  Graph to = from.empty_like();
  std::vector<Value> moved(static_cast<std::size_t>(from.size()), no_value);
  const std::function<Value(Value)> visit = [&](Value v) {
    Value& target = moved[static_cast<std::size_t>(v)];
    if (target != no_value) return target;
    Node node = from[v];
    for (int i = 0; i < arity(node.op); ++i) node.operand(i) = visit(node.operand(i));
    target = to.add(node);
    to.set_label(target, from.label(v));
    return target;
  };
  for (std::size_t i = 0; i < from.outputs.size(); ++i)
    for (std::size_t j = 0; j < from.outputs[i].values.size(); ++j)
      to.outputs[i].values[j] = visit(from.outputs[i].values[j]);
  return to;
}

}  // namespace

Graph lower(const Function& function) {
  return renumber(Lowering(function).run());
}

}  // namespace sinew

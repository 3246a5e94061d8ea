// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/error_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sinew {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double margin = 1.0 + 1e-6;  // second-order terms

struct Known {
  double value = 0.0;
  double error = 0.0;
};

/// error * slope, where an exact operand has no error at a pole of the slope either.
double times(double slope, double error) {
  return error == 0.0 ? 0.0 : slope * error;
}

double product_error(const Known& a, const Known& b) {
  return std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error;
}

double quotient_error(const Known& a, const Known& b) {
  const double least = std::abs(b.value) - b.error;
  if (least <= 0.0) return unlimited;
  return a.error / least + times(std::abs(a.value) / (least * least), b.error);
}

double root_error(const Known& a) {
  const double least = a.value - a.error;
  if (a.error == 0.0) return 0.0;
  return least > 0.0 ? a.error / (2.0 * std::sqrt(least)) : unlimited;
}

double arc_error(const Known& a) {
  const double largest = std::abs(a.value) + a.error;
  if (a.error == 0.0) return 0.0;
  return largest < 1.0 ? a.error / std::sqrt(1.0 - largest * largest) : unlimited;
}

double arctangent2_error(const Known& y, const Known& x) {
  const double square = y.value * y.value + x.value * x.value;
  return times(std::abs(x.value) / square, y.error) + times(std::abs(y.value) / square, x.error);
}

double choose_error(const Known& a, const Known& b, const Known& c) {
  if (a.error > 0.0 && std::abs(a.value) <= a.error) return unlimited;
  return a.value >= 0.0 ? b.error : c.error;
}

/// What the operands' errors become.
double passed_on(const Node& node, const Known& a, const Known& b, const Known& c) {
  switch (node.op) {
    case Op::input:
    case Op::constant:
      return 0.0;
    case Op::add:
    case Op::subtract:
      return a.error + b.error;
    case Op::multiply:
      return product_error(a, b);
    case Op::divide:
      return quotient_error(a, b);
    case Op::power:
      return times(node.index * std::pow(std::abs(a.value) + a.error, node.index - 1), a.error);
    case Op::square_root:
      return root_error(a);
    case Op::arctangent2:
      return arctangent2_error(a, b);
    case Op::arccosine:
    case Op::arcsine:
      return arc_error(a);
    case Op::exponential:
      return std::exp(a.value) * std::expm1(a.error);
    case Op::logarithm:
      return a.error < a.value ? a.error / (a.value - a.error) : times(unlimited, a.error);
    case Op::minimum:
    case Op::maximum:
      return std::max(a.error, b.error);
    case Op::choose:
      return choose_error(a, b, c);
    case Op::multiply_add:
    case Op::multiply_subtract:
    case Op::subtract_product:
      return product_error(a, b) + c.error;
    case Op::negate:
    case Op::absolute:
    case Op::sine:
    case Op::cosine:
    case Op::arctangent:
    case Op::hyperbolic_tangent:
      return a.error;  // slopes of one at most
  }
  return unlimited;
}

/// Roundings of one operation, as multiples of its result.
double rounded(const Node& node, const Rounding& rounding) {
  switch (node.op) {
    case Op::constant:
      return rounding.constant;
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
    case Op::square_root:
      return rounding.operation;
    case Op::power:
      return (node.index - 1) * rounding.operation;
    case Op::sine:
    case Op::cosine:
    case Op::arctangent:
    case Op::arctangent2:
    case Op::arccosine:
    case Op::arcsine:
    case Op::exponential:
    case Op::logarithm:
      return rounding.function;
    case Op::hyperbolic_tangent:
      return 3.0 * rounding.function;
    default:
      return 0.0;
  }
}

}  // namespace

std::vector<double> error_bounds(const Graph& graph, const std::vector<double>& inputs,
                                 const Rounding& rounding) {
  std::vector<Known> known;
  std::vector<Exact> exact;
  std::vector<bool> folds;  // known at generation time
  for (const Node& node : graph.nodes()) {
    Exact x[3];
    Known k[3];
    bool fold = node.op != Op::input;
    for (int i = 0; i < arity(node.op); ++i) {
      const auto at = static_cast<std::size_t>(node.operand(i));
      x[i] = exact[at];
      k[i] = known[at];
      fold = fold && folds[at];
    }
    exact.push_back(node.op == Op::input ? Exact(inputs[static_cast<std::size_t>(node.index)])
                                         : apply<Exact>(node, x[0], x[1], x[2]));
    const double value = static_cast<double>(exact.back());
    const double relative =
        rounded(node, rounding) + (fold && arity(node.op) > 0 ? rounding.folded : 0.0);
    known.push_back(
        {value, margin * (passed_on(node, k[0], k[1], k[2]) + relative * std::abs(value))});
    folds.push_back(fold);
  }
  std::vector<double> bounds;
  for (Value v : graph.results()) bounds.push_back(known[static_cast<std::size_t>(v)].error);
  return bounds;
}

RelativeErrors relative_errors(const Graph& graph, const std::vector<std::vector<double>>& states) {
  RelativeErrors errors;
  for (const std::vector<double>& inputs : states) {
    const std::vector<double> got = evaluate<double>(graph, inputs),
                              bounds = error_bounds(graph, inputs, double_rounding);
    const std::vector<Exact> exact =
        evaluate<Exact>(graph, std::vector<Exact>(inputs.begin(), inputs.end()));
    std::size_t first = 0;
    for (const Port& port : graph.outputs) {
      const std::size_t end = first + static_cast<std::size_t>(port.size());
      double size = 0.0, bound = 0.0;
      for (std::size_t i = first; i < end; ++i) {
        size = std::max(size, std::abs(got[i]));
        bound = std::max(bound, bounds[i]);
      }
      const bool is_rounding = size <= bound && std::isfinite(bound);
      for (; first < end; ++first) {
        if (size == 0.0 || is_rounding) continue;
        const double off = std::abs(static_cast<double>(Exact(exact[first] - Exact(got[first]))));
        errors.observed = std::max(errors.observed, off / size);
        errors.bound = std::max(errors.bound, bounds[first] / size);
      }
    }
  }
  return errors;
}

}  // namespace sinew

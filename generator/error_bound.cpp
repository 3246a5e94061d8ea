// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/error_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generator/evaluate.h"

namespace sinew {
namespace {

constexpr double half_unit = std::numeric_limits<double>::epsilon() / 2.0;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A value and how far it may be off.
struct Off {
  double value = 0.0, by = 0.0;
};

/// What a function of slope `slope` makes of its argument's error.
double passed_on(double slope, const Off& a) {
  return a.by == 0.0 ? 0.0 : std::abs(slope) * a.by;
}

/// Without the operation's own rounding; `v`: its result.
double carried(const Node& node, const Off& a, const Off& b, const Off& c, double v) {
  switch (node.op) {
    case Op::input:
    case Op::constant:
      return 0.0;
    case Op::add:
    case Op::subtract:
      return a.by + b.by;
    case Op::multiply:
      return std::abs(a.value) * b.by + std::abs(b.value) * a.by;
    case Op::divide:
      return b.value == 0.0 ? infinite : (a.by + std::abs(v) * b.by) / std::abs(b.value);
    case Op::power:
      return passed_on(node.index * std::pow(a.value, node.index - 1), a);
    case Op::square_root:
      return a.by == 0.0 ? 0.0 : v > 0.0 ? a.by / (2.0 * v) : std::sqrt(a.by);
    case Op::arctangent:
      return passed_on(1.0 / (1.0 + a.value * a.value), a);
    case Op::arctangent2: {
      const double square = a.value * a.value + b.value * b.value;
      return square == 0.0 ? infinite
                           : (std::abs(b.value) * a.by + std::abs(a.value) * b.by) / square;
    }
    case Op::arccosine:
    case Op::arcsine:
      return std::abs(a.value) < 1.0 ? passed_on(1.0 / std::sqrt(1.0 - a.value * a.value), a)
                                     : std::sqrt(2.0 * a.by);
    case Op::exponential:
      return passed_on(v, a);
    case Op::logarithm:
      return a.value == 0.0 ? infinite : passed_on(1.0 / a.value, a);
    case Op::minimum:
    case Op::maximum:
      return std::max(a.by, b.by);
    case Op::choose:
      if (std::abs(a.value) <= a.by && a.by > 0.0)
        return std::max(b.by, c.by) + std::abs(b.value - c.value);
      return a.value >= 0.0 ? b.by : c.by;
    case Op::multiply_add:
    case Op::multiply_subtract:
    case Op::subtract_product:
      return std::abs(a.value) * b.by + std::abs(b.value) * a.by + c.by;
    default:  // slopes of sine, cosine, tanh, sign and size are at most 1
      return a.by;
  }
}

/// Units of half the last place that the operation itself is off by.
double own_rounding(const Node& node) {
  switch (node.op) {
    case Op::input:
    case Op::constant:
    case Op::negate:
    case Op::absolute:
    case Op::minimum:
    case Op::maximum:
    case Op::choose:
      return 0.0;
    case Op::power:
      return node.index - 1;
    case Op::add:
    case Op::subtract:
    case Op::multiply:
    case Op::divide:
    case Op::square_root:
    case Op::multiply_add:
    case Op::multiply_subtract:
    case Op::subtract_product:
      return 1.0;
    case Op::hyperbolic_tangent:
      return 5.0;
    default:
      return 2.0;
  }
}

double largest_of(const std::vector<double>& values, std::size_t first, std::size_t count) {
  double most = 0.0;
  for (std::size_t i = first; i < first + count; ++i) most = std::max(most, std::abs(values[i]));
  return most;
}

}  // namespace

BoundedResults evaluate_with_bounds(const Graph& graph, const std::vector<double>& inputs) {
  std::vector<Off> values;
  values.reserve(static_cast<std::size_t>(graph.size()));
  const Off none;
  for (const Node& node : graph.nodes()) {
    const auto at = [&](Value v) -> const Off& {
      return v == no_value ? none : values[static_cast<std::size_t>(v)];
    };
    const Off &a = at(node.a), &b = at(node.b), &c = at(node.c);
    const double v = node.op == Op::input ? inputs.at(static_cast<std::size_t>(node.index))
                                          : apply<double>(node, a.value, b.value, c.value);
    values.push_back({v, carried(node, a, b, c, v) + own_rounding(node) * half_unit * std::abs(v)});
  }
  BoundedResults results;
  for (const Value v : graph.results()) {
    results.values.push_back(values[static_cast<std::size_t>(v)].value);
    results.bounds.push_back(values[static_cast<std::size_t>(v)].by);
  }
  return results;
}

RelativeErrors relative_errors(const Graph& graph, const std::vector<std::vector<double>>& states) {
  RelativeErrors errors;
  for (const std::vector<double>& inputs : states) {
    const BoundedResults got = evaluate_with_bounds(graph, inputs);
    const std::vector<Exact> exact =
        evaluate<Exact>(graph, std::vector<Exact>(inputs.begin(), inputs.end()));
    std::size_t first = 0;
    for (const Port& port : graph.outputs) {
      const auto count = static_cast<std::size_t>(port.size());
      const double size = largest_of(got.values, first, count);
      for (std::size_t i = first; size > 0.0 && i < first + count; ++i) {
        const Exact difference = exact[i] - Exact(got.values[i]);
        errors.observed =
            std::max(errors.observed, std::abs(static_cast<double>(difference)) / size);
        errors.bound = std::max(errors.bound, got.bounds[i] / size);
      }
      first += count;
    }
  }
  return errors;
}

}  // namespace sinew

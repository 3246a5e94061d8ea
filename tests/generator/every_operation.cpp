// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/generator/every_operation.h"

#include <string>

#include "symbolic/expressions/piecewise.h"
#include "tests/reference/sampling.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

Argument argument(const std::string& name, int size, Range range) {
  Argument result;
  result.name = name;
  result.rows = size;
  for (int i = 0; i < size; ++i) {
    result.symbols.emplace_back(name + std::to_string(i));
    result.ranges.push_back(range);
  }
  return result;
}

/// Sums, products, quotients and powers.
std::vector<ex> algebraic(const std::vector<symbol>& a, const std::vector<symbol>& b) {
  const ex divisor = a[2] + 1;
  return {a[0] + b[0] - 3 * a[1],
          a[0] * b[0] / a[1],
          -(a[0] * b[1]),
          pow(b[0], 5) + pow(a[0], -3),
          sqrt(a[0]) + pow(a[1], numeric(3, 2)),
          a[0] / divisor + a[1] / divisor,
          (b[0] - b[1]) * (b[1] - a[3]) + sin(b[0] - b[1]) * cos(b[1] - b[0]),
          a[0] * b[0] + a[0] * b[1] - a[0] * a[1] + a[2]};
}

/// The functions of the runtime.
std::vector<ex> transcendental(const std::vector<symbol>& a, const std::vector<symbol>& b) {
  return {sin(b[0]) * cos(b[1]),
          sin(sin(b[0])) + cos(sin(cos(b[0]))),
          atan(b[0]) + atan2(b[0], b[1]),
          acos(a[0]) + asin(a[1]),
          exp(b[0]) + log(a[0]) + tanh(b[1]),
          abs(b[0] + b[1]) * a[3],
          minimum(b[0], b[1]) + maximum(a[0], b[1]),
          choose(b[0], a[0], a[1]),
          pow(sin(b[0]), 2) + pow(cos(b[0]), 2) + a[0],
          sin(ex(2) / 3) * a[0] + sqrt(ex(2)) * a[1]};
}

}  // namespace

Function every_operation() {
  Function function;
  function.name = "every_operation";
  function.doc = "Uses every operation of a graph.";
  function.inputs = {argument("a", 4, {0.2, 0.9}), argument("b", 2, {-2.0, 2.0})};
  // b[0] and b[1] lie on different sides of zero: never both zero, never equal.
  function.inputs[1].ranges = {{0.1, 2.0}, {-2.0, -0.1}};
  const std::vector<symbol>&a = function.inputs[0].symbols, &b = function.inputs[1].symbols;
  // Constants that GiNaC cannot merge because definitions cut the expressions.
  const symbol two("two"), third("third"), doubled("doubled"), tripled("tripled"), above("above"),
      below("below");
  function.definitions = {{two, 2},
                          {third, numeric(1, 3)},
                          {doubled, two * a[0]},
                          {tripled, third * b[0]},
                          {above, a[1] + numeric(1, 10)},
                          {below, b[1] - numeric(7, 10)}};
  Output output;
  output.name = "r";
  output.values = algebraic(a, b);
  for (const ex& value : transcendental(a, b)) output.values.push_back(value);
  output.values.emplace_back(doubled * tripled);
  output.values.emplace_back(above + below + two * third);
  output.rows = static_cast<int>(output.values.size());
  function.outputs = {output};
  return function;
}

std::vector<std::vector<double>> states_of(const Graph& graph, int count, std::uint64_t seed) {
  reference::Box box;
  for (const Port& port : graph.inputs)
    for (const Range& range : port.ranges) {
      box.low.push_back(range.low);
      box.high.push_back(range.high);
    }
  return reference::sample_box(box, count, seed);
}

}  // namespace sinew

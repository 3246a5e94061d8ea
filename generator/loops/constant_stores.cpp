// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/constant_stores.h"

#include <algorithm>

namespace sinew {
namespace {

/// Fewer stores, or fewer rows, are not worth a loop's counter.
constexpr int fewest_rows = 3;
constexpr std::size_t fewest_columns = 4;

/// The constants of a row that no loop stores, by column; no_value where there is none.
std::vector<Value> constants_of_row(const Graph& graph, const Plan& plan, std::size_t port,
                                    int row) {
  const Port& results = graph.outputs[port];
  std::vector<Value> constants;
  for (int col = 0; col < results.cols; ++col) {
    const auto element = static_cast<std::size_t>(row * results.cols + col);
    const Value v = results.values[element];
    const bool is_free = graph.is_constant(v) && !plan.stored[port][element];
    constants.push_back(is_free ? v : no_value);
  }
  return constants;
}

Loop loop_over_rows(const Graph& graph, std::size_t port, int first, int count,
                    const std::vector<Value>& constants) {
  Loop loop;
  loop.count = count;
  loop.body.name = graph.name;
  loop.body.inputs = {{"leaf", 0, 1, "", "", {}, {}}};
  loop.body.outputs = {{"result", 0, 1, "", "", {}, {}}};
  Port& body = loop.body.outputs[0];
  const int cols = graph.outputs[port].cols;
  for (int col = 0; col < cols; ++col) {
    const Value v = constants[static_cast<std::size_t>(col)];
    if (v == no_value) continue;
    LoopResult result{static_cast<int>(port), {}, no_value, no_value, {}};
    for (int row = first; row < first + count; ++row) result.elements.push_back(row * cols + col);
    loop.results.push_back(std::move(result));
    body.values.push_back(loop.body.constant(graph[v].constant));
  }
  body.rows = static_cast<int>(body.values.size());
  return loop;
}

std::size_t constants_in(const std::vector<Value>& row) {
  return static_cast<std::size_t>(
      std::count_if(row.begin(), row.end(), [](Value v) { return v != no_value; }));
}

/// What both rows have.
std::vector<Value> common(const std::vector<Value>& a, const std::vector<Value>& b) {
  std::vector<Value> both;
  for (std::size_t col = 0; col < a.size(); ++col)
    both.push_back(a[col] == b[col] ? a[col] : no_value);
  return both;
}

}  // namespace

std::vector<Loop> loops_of_constants(const Graph& graph, const Plan& plan) {
  std::vector<Loop> loops;
  for (std::size_t port = 0; port < graph.outputs.size(); ++port) {
    const int rows = graph.outputs[port].rows;
    for (int row = 0; row < rows;) {
      std::vector<Value> shared = constants_of_row(graph, plan, port, row);
      const std::size_t enough = std::max(fewest_columns, constants_in(shared) * 3 / 4);
      int count = 1;
      for (; row + count < rows; ++count) {
        const std::vector<Value> both =
            common(shared, constants_of_row(graph, plan, port, row + count));
        if (constants_in(both) < enough) break;
        shared = both;
      }
      if (count >= fewest_rows && constants_in(shared) >= fewest_columns)
        loops.push_back(loop_over_rows(graph, port, row, count, shared));
      row += count;
    }
  }
  return loops;
}

}  // namespace sinew

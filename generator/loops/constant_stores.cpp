// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/constant_stores.h"

#include <algorithm>

namespace sinew {
namespace {

/// Fewer stores, or fewer rows, are not worth a loop's counter; nor is a loop that saves fewer
/// statements.
constexpr int fewest_rows = 3;
constexpr std::size_t fewest_columns = 2;
constexpr int fewest_saved = 8;

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

/// Rows one after the other with the same constants in some columns.
struct ConstantRows {
  int first = 0;
  int count = 0;
  std::vector<Value> constants;
  int saved() const {
    return (count - 1) * static_cast<int>(constants_in(constants)) - 2;  // its head and its end
  }
};

/// Those that save most statements.
ConstantRows most_constant_rows(const std::vector<std::vector<Value>>& rows) {
  ConstantRows best;
  for (std::size_t first = 0; first < rows.size(); ++first) {
    ConstantRows now{static_cast<int>(first), 1, rows[first]};
    for (std::size_t row = first + 1; row < rows.size(); ++row) {
      now.constants = common(now.constants, rows[row]);
      ++now.count;
      if (constants_in(now.constants) < fewest_columns) break;
      if (now.count >= fewest_rows && now.saved() > best.saved()) best = now;
    }
  }
  return best;
}

}  // namespace

std::vector<Loop> loops_of_constants(const Graph& graph, const Plan& plan) {
  std::vector<Loop> loops;
  for (std::size_t port = 0; port < graph.outputs.size(); ++port) {
    std::vector<std::vector<Value>> rows;
    for (int row = 0; row < graph.outputs[port].rows; ++row)
      rows.push_back(constants_of_row(graph, plan, port, row));
    while (true) {
      const ConstantRows most = most_constant_rows(rows);
      if (most.saved() < fewest_saved) break;
      loops.push_back(loop_over_rows(graph, port, most.first, most.count, most.constants));
      for (int row = most.first; row < most.first + most.count; ++row)
        for (std::size_t col = 0; col < most.constants.size(); ++col)
          if (most.constants[col] != no_value) rows[static_cast<std::size_t>(row)][col] = no_value;
    }
  }
  return loops;
}

}  // namespace sinew

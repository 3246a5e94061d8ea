// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/reference.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <sstream>

#include "generator/evaluate.h"

namespace sinew {
namespace {

template <class Real>
std::vector<double> results_as(const Graph& graph, const std::vector<double>& inputs) {
  const std::vector<Real> results =
      evaluate<Real>(graph, std::vector<Real>(inputs.begin(), inputs.end()));
  return {results.begin(), results.end()};
}

std::string rows(const std::string& start, const std::vector<Port>& ports,
                 const std::vector<double>& values) {
  std::string text;
  std::size_t next = 0;
  for (const Port& port : ports) {
    text += start + port.name;
    for (int i = 0; i < port.size(); ++i) text += fmt::format(",{}", values[next++]);
    text += "\n";
  }
  return text;
}

std::string state_rows(const EmittedModel& model, const Graph& graph, const char* state,
                       const std::vector<double>& inputs) {
  const std::string start = fmt::format("{}_{},{},", model.name, graph.name, state);
  return rows(start, graph.inputs, inputs) +
         rows(start, graph.outputs, results_at(graph, model.target, inputs));
}

double within(const Range& range, std::size_t element) {
  const double spread = 0.618 * static_cast<double>(element + 1);
  const double part = 0.5 + 0.4 * (spread - std::floor(spread));
  return (1 - part) * range.low + part * range.high;
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
  return result;
}

}  // namespace

std::vector<double> reference_inputs(const Graph& graph) {
  std::vector<double> inputs = beside_inputs(graph);
  std::size_t next = 0;
  for (const Port& port : graph.inputs)
    for (std::size_t i = 0; i < static_cast<std::size_t>(port.size()); ++i, ++next)
      if (!port.reference.empty()) inputs[next] = port.reference.at(i);
  return inputs;
}

std::vector<double> beside_inputs(const Graph& graph) {
  std::vector<double> inputs;
  for (const Port& port : graph.inputs)
    for (std::size_t i = 0; i < static_cast<std::size_t>(port.size()); ++i)
      inputs.push_back(port.ranges.empty() ? 0.0 : within(port.ranges[i], i));
  return inputs;
}

std::vector<double> results_at(const Graph& graph, const Target& target,
                               const std::vector<double>& inputs) {
  return target.scalar == Scalar::binary32 ? results_as<float>(graph, inputs)
                                           : results_as<double>(graph, inputs);
}

std::string emit_reference(const EmittedModel& model) {
  std::string text = "# SPDX-License-Identifier: BSD-2-Clause\nfunction,state,argument,values\n";
  for (const Graph& graph : model.functions) {
    const std::vector<double> reference = reference_inputs(graph), beside = beside_inputs(graph);
    text += state_rows(model, graph, "reference", reference);
    if (beside != reference) text += state_rows(model, graph, "beside", beside);
  }
  return text;
}

ReferenceTable read_reference(const std::string& text) {
  ReferenceTable table;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::vector<std::string> row = cells(line);
    if (row.size() < 4) continue;
    std::vector<double> values;
    for (std::size_t i = 3; i < row.size(); ++i) {
      double value = 0;
      const char* const end = row[i].data() + row[i].size();
      if (std::from_chars(row[i].data(), end, value).ptr != end) break;
      values.push_back(value);
    }
    if (values.size() + 3 == row.size()) table[row[0] + " " + row[1]][row[2]] = std::move(values);
  }
  return table;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/models/change_summary.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "generator/cost.h"
#include "generator/reference.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;
using Kind = FunctionChange::Kind;
using Values = std::vector<double>;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// What was emitted before.
struct Before {
  std::string code;
  std::map<std::string, std::optional<int>> operations;  ///< by function
  ReferenceTable values;

  Before(const fs::path& folder, const EmittedModel& model)
      : code(content(folder / (model.name + ".c"))),
        values(read_reference(content(folder / "reference.csv"))) {
    const nlohmann::json manifest =
        nlohmann::json::parse(content(folder / "manifest.json"), nullptr, false);
    if (!manifest.is_object() || !manifest.contains("functions")) return;
    for (const auto& function : manifest["functions"]) {
      if (!function.is_object()) continue;
      const std::string name = function.value("name", "");
      const auto counts = function.value("operations", nlohmann::json::object());
      operations[name] = counts.contains("multiply_add") && counts["multiply_add"].is_number()
                             ? std::optional<int>(counts["multiply_add"].get<int>())
                             : std::nullopt;
    }
  }
};

/// Of a function in emitted C, "" where it has none.
std::string definition_of(const std::string& function, const std::string& code) {
  const std::size_t start = code.find("\nvoid " + function + "("),
                    end = start == std::string::npos ? start : code.find("\n}\n", start);
  return end == std::string::npos ? "" : code.substr(start, end - start);
}

ValueChange difference_of(const double* now, const Values& before) {
  ValueChange change;
  double size = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    change.largest = std::max(change.largest, std::abs(now[i] - before[i]));
    size = std::max(size, std::abs(before[i]));
  }
  if (size > 0) change.relative = change.largest / size;
  return change;
}

/// The rows of one function in one state, in the order of its ports; nothing unless all fit.
std::optional<std::vector<Values>> port_values(const ReferenceTable& table, const std::string& key,
                                               const std::vector<Port>& ports) {
  const auto rows = table.find(key);
  if (rows == table.end()) return std::nullopt;
  std::vector<Values> values;
  for (const Port& port : ports) {
    const auto row = rows->second.find(port.name);
    if (row == rows->second.end() || static_cast<int>(row->second.size()) != port.size())
      return std::nullopt;
    values.push_back(row->second);
  }
  return values;
}

/// Changes of all results where the new function is given the old inputs.
std::vector<ValueChange> changes_in(const std::string& key, const ReferenceTable& before,
                                    const Graph& graph, const Target& target) {
  const auto inputs = port_values(before, key, graph.inputs),
             outputs = port_values(before, key, graph.outputs);
  if (!inputs || !outputs) return {};
  Values flat;
  for (const Values& input : *inputs) flat.insert(flat.end(), input.begin(), input.end());
  const Values now = results_at(graph, target, flat);
  std::vector<ValueChange> changes;
  const double* next = now.data();
  for (const Values& output : *outputs) {
    changes.push_back(difference_of(next, output));
    next += output.size();
  }
  return changes;
}

std::vector<ResultChange> result_changes(const std::string& name, const ReferenceTable& before,
                                         const Graph& graph, const Target& target) {
  const std::vector<ValueChange> reference = changes_in(name + " reference", before, graph, target),
                                 beside = changes_in(name + " beside", before, graph, target);
  std::vector<ResultChange> results;
  for (std::size_t i = 0; i < reference.size(); ++i)
    results.push_back({graph.outputs[i].name, graph.outputs[i].unit, reference[i],
                       i < beside.size() ? beside[i] : reference[i]});
  return results;
}

std::string amount(const ValueChange& change, const std::string& unit) {
  std::string text = fmt::format("{:.3g}{}", change.largest, unit == "1" ? "" : " " + unit);
  // Of something next to nothing a share says nothing.
  if (change.relative && *change.relative < 10)
    text += fmt::format(" ({:.3g} %)", 100 * *change.relative);
  return text;
}

std::string operations_text(const FunctionChange& change) {
  const auto number = [](const std::optional<int>& count) {
    return count ? std::to_string(*count) : std::string("?");
  };
  if (change.kind == Kind::added) return number(change.operations_after);
  if (change.kind == Kind::removed) return number(change.operations_before);
  return number(change.operations_before) + " -> " + number(change.operations_after);
}

const char* word(Kind kind) {
  switch (kind) {
    case Kind::changed:
      return "changed";
    case Kind::added:
      return "new";
    case Kind::removed:
      return "removed";
    default:
      return "unchanged";
  }
}

std::string line(const FunctionChange& change, std::size_t width) {
  std::string text = fmt::format("  {:<9} {:<{}}  {:>14} operations", word(change.kind),
                                 change.name, width, operations_text(change));
  if (change.kind == Kind::changed && change.results.empty())
    text += "; no values known from before";
  std::string results;
  for (const ResultChange& result : change.results) {
    if (result.reference.largest > 0)
      results += fmt::format("; {} {}", result.name, amount(result.reference, result.unit));
    else if (result.beside.largest > 0)
      results +=
          fmt::format("; {} 0, beside it {}", result.name, amount(result.beside, result.unit));
  }
  text += results.empty() && !change.results.empty() ? "; the same results" : results;
  return text + "\n";
}

nlohmann::ordered_json value_json(const ValueChange& change) {
  nlohmann::ordered_json json{{"largest", change.largest}, {"relative", nullptr}};
  if (change.relative) json["relative"] = *change.relative;
  return json;
}

}  // namespace

std::vector<FunctionChange> function_changes(const fs::path& folder, const EmittedModel& model,
                                             const std::string& code) {
  const Before before(folder, model);
  std::vector<FunctionChange> changes;
  std::map<std::string, std::optional<int>> gone = before.operations;
  for (const Graph& graph : model.functions) {
    FunctionChange change;
    change.name = model.name + "_" + graph.name;
    change.operations_after = count_operations(graph).operations();
    const auto known = before.operations.find(change.name);
    if (known == before.operations.end()) {
      change.kind = Kind::added;
    } else {
      change.operations_before = known->second;
      gone.erase(change.name);
      if (definition_of(change.name, code) != definition_of(change.name, before.code)) {
        change.kind = Kind::changed;
        change.results = result_changes(change.name, before.values, graph, model.target);
      }
    }
    changes.push_back(std::move(change));
  }
  for (const auto& [name, operations] : gone)
    changes.push_back({name, Kind::removed, operations, std::nullopt, {}});
  return changes;
}

std::string summary_text(const std::vector<FunctionChange>& changes) {
  std::size_t width = 0, unchanged = 0, added = 0;
  for (const FunctionChange& change : changes) {
    unchanged += change.kind == Kind::unchanged;
    added += change.kind == Kind::added;
    if (change.kind != Kind::unchanged) width = std::max(width, change.name.size());
  }
  if (unchanged == changes.size())
    return fmt::format("  no function changed ({} unchanged)\n", unchanged);
  if (added == changes.size()) return fmt::format("  all {} functions are new\n", added);
  std::string text;
  for (const FunctionChange& change : changes)
    if (change.kind != Kind::unchanged) text += line(change, width);
  text += fmt::format(
      "  {} unchanged. Results: largest change at the reference pose "
      "(and in % of the largest element before)\n",
      unchanged);
  return text;
}

nlohmann::ordered_json summary_json(const std::vector<FunctionChange>& changes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const FunctionChange& change : changes) {
    nlohmann::ordered_json json{{"name", change.name},
                                {"change", word(change.kind)},
                                {"operations_before", nullptr},
                                {"operations_after", nullptr},
                                {"results", nlohmann::ordered_json::array()}};
    if (change.operations_before) json["operations_before"] = *change.operations_before;
    if (change.operations_after) json["operations_after"] = *change.operations_after;
    for (const ResultChange& result : change.results)
      json["results"].push_back({{"name", result.name},
                                 {"unit", result.unit},
                                 {"reference", value_json(result.reference)},
                                 {"beside", value_json(result.beside)}});
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace sinew

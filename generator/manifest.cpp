// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/manifest.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "generator/cost.h"
#include "generator/write.h"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

Json port_json(const Port& port) {
  Json json{{"name", port.name}, {"rows", port.rows}, {"cols", port.cols}, {"unit", port.unit}};
  if (!port.ranges.empty()) {
    json["low"] = Json::array();
    json["high"] = Json::array();
    for (const Range& range : port.ranges) {
      json["low"].push_back(range.low);
      json["high"].push_back(range.high);
    }
  }
  return json;
}

Json function_json(const EmittedModel& model, const Graph& graph) {
  Json json{
      {"name", model.name + "_" + graph.name}, {"doc", graph.doc}, {"equation", graph.equation}};
  json["inputs"] = Json::array();
  for (const Port& port : graph.inputs) json["inputs"].push_back(port_json(port));
  json["outputs"] = Json::array();
  for (const Port& port : graph.outputs) json["outputs"].push_back(port_json(port));
  const Cost cost = count_operations(graph);
  json["operations"] = {{"multiply", cost.multiply}, {"add", cost.add},
                        {"negate", cost.negate},     {"divide", cost.divide},
                        {"sqrt", cost.square_root},  {"sincos", cost.sincos},
                        {"other", cost.other},       {"multiply_add", cost.operations()}};
  return json;
}

}  // namespace

std::string emit_manifest(const EmittedModel& model) {
  Json json{{"model", model.name}, {"sha256", model.hash}, {"scalar", model.target.type()}};
  json["files"] = Json::array();
  for (const std::string& file : emitted_file_names(model)) json["files"].push_back(file);
  json["functions"] = Json::array();
  for (const Graph& graph : model.functions)
    json["functions"].push_back(function_json(model, graph));
  return json.dump(2) + "\n";
}

}  // namespace sinew

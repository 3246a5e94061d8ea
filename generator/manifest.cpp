// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/manifest.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "generator/cost.h"
#include "generator/write.h"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

Json port_json(const EmittedModel& model, const std::string& function, const Port& port) {
  Json json{{"name", port.name}, {"rows", port.rows}, {"cols", port.cols}, {"unit", port.unit}};
  if (!port.doc.empty()) json["doc"] = port.doc;
  if (port.by_value) json["by_value"] = true;
  if (!port.states.empty()) json["states"] = port.states;
  const std::string order = name_of(order_of(model.naming, function, port));
  if (!order.empty()) json["order"] = order;
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
  for (const Port& port : graph.inputs)
    json["inputs"].push_back(port_json(model, graph.name, port));
  json["outputs"] = Json::array();
  for (const Port& port : graph.outputs)
    json["outputs"].push_back(port_json(model, graph.name, port));
  const Cost cost = count_operations(graph);
  json["operations"] = {{"multiply", cost.multiply}, {"add", cost.add},
                        {"negate", cost.negate},     {"divide", cost.divide},
                        {"sqrt", cost.square_root},  {"sincos", cost.sincos},
                        {"other", cost.other},       {"multiply_add", cost.operations()}};
  return json;
}

Json joint_json(const NamedJoint& joint) {
  Json json{{"name", joint.name}, {"type", joint.type}, {"unit", joint.unit}};
  if (!joint.body.empty()) {
    json["parent"] = joint.parent;
    json["body"] = joint.body;
    json["low"] = joint.low;
    json["high"] = joint.high;
    json["reference"] = joint.reference;
    json["damping"] = joint.damping;
  }
  if (!joint.source_name.empty()) json["source_name"] = joint.source_name;
  return json;
}

void add_naming(Json& json, const Naming& naming) {
  json["joints"] = Json::array();
  for (const NamedJoint& joint : naming.joints) json["joints"].push_back(joint_json(joint));
  if (!naming.wrist.empty()) json["wrist"] = naming.wrist;
  json["tendons"] = Json::array();
  for (const NamedTendon& tendon : naming.tendons) {
    Json entry{{"name", tendon.name}};
    if (!tendon.joints.empty()) entry["joints"] = tendon.joints;
    if (!tendon.bodies.empty()) entry["bodies"] = tendon.bodies;
    json["tendons"].push_back(entry);
  }
  json["frames"] = Json::array();
  for (const NamedFrame& frame : naming.frames)
    json["frames"].push_back({{"name", frame.name}, {"body", frame.body}});
  if (naming.gravity) json["gravity"] = *naming.gravity;
}

}  // namespace

std::string emit_manifest(const EmittedModel& model) {
  Json json{{"model", model.name},
            {"sha256", model.hash},
            {"scalar", model.target.type()},
            {"description", model.description}};
  json["files"] = Json::array();
  for (const std::string& file : emitted_file_names(model)) json["files"].push_back(file);
  add_naming(json, model.naming);
  json["functions"] = Json::array();
  for (const Graph& graph : model.functions)
    json["functions"].push_back(function_json(model, graph));
  return json.dump(2) + "\n";
}

}  // namespace sinew

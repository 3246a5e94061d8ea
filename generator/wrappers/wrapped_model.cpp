// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/wrappers/wrapped_model.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace sinew {
namespace {

using nlohmann::json;

WrappedArray array_of(const json& port) {
  WrappedArray array{port.at("name"),
                     port.at("rows"),
                     port.at("cols"),
                     port.value("unit", ""),
                     port.value("doc", ""),
                     port.value("order", ""),
                     {},
                     {},
                     port.value("by_value", false),
                     port.value("states", std::vector<std::string>{})};
  for (const auto& low : port.value("low", json::array())) array.low.push_back(low);
  for (const auto& high : port.value("high", json::array())) array.high.push_back(high);
  return array;
}

WrappedFunction function_of(const json& entry, const std::string& model,
                            const std::string& batch_header) {
  const std::string full = entry.at("name");
  WrappedFunction function{full.substr(model.size() + 1),
                           entry.value("doc", ""),
                           entry.value("equation", ""),
                           {},
                           {},
                           false};
  for (const json& port : entry.at("inputs")) function.inputs.push_back(array_of(port));
  for (const json& port : entry.at("outputs")) function.outputs.push_back(array_of(port));
  function.has_batch = batch_header.find(" " + full + "_batch(") != std::string::npos;
  return function;
}

WrappedModel understood(const json& manifest, const FileSet& emitted) {
  WrappedModel model;
  model.name = manifest.at("model");
  model.description = manifest.value("description", model.name);
  model.hash = manifest.at("sha256");
  model.scalar = manifest.at("scalar");
  for (const json& joint : manifest.value("joints", json::array()))
    model.joints.push_back({joint.at("name"), joint.at("type"), joint.at("unit"),
                            joint.value("source_name", joint.at("name").get<std::string>()),
                            joint.value("low", 0.0), joint.value("high", 0.0),
                            joint.value("reference", 0.0), joint.value("damping", 0.0)});
  for (const json& tendon : manifest.value("tendons", json::array()))
    model.tendons.push_back(tendon.at("name"));
  for (const json& frame : manifest.value("frames", json::array()))
    model.frames.push_back(frame.at("name"));
  for (const json& angle : manifest.value("wrist", json::array())) model.wrist.push_back(angle);
  const auto batch = emitted.find(std::string(host_sources) + model.name + "_batch.h");
  for (const json& entry : manifest.at("functions"))
    model.functions.push_back(
        function_of(entry, model.name, batch == emitted.end() ? "" : batch->second));
  return model;
}

}  // namespace

const WrappedFunction* WrappedModel::find(const std::string& wanted) const {
  for (const WrappedFunction& function : functions)
    if (function.name == wanted) return &function;
  return nullptr;
}

WrappedModel wrapped_model(const FileSet& emitted, FileSet runtime) {
  const auto manifest = emitted.find("manifest.json");
  if (manifest == emitted.end())
    throw std::runtime_error("manifest.json is missing among the emitted files");
  try {
    WrappedModel model = understood(json::parse(manifest->second), emitted);
    model.manifest = manifest->second;
    for (const auto& [name, text] : emitted)
      if (name.ends_with(".c") || name.ends_with(".h")) model.sources[name] = text;
    model.runtime = std::move(runtime);
    return model;
  } catch (const json::exception& error) {
    throw std::runtime_error(std::string("manifest.json: ") + error.what());
  }
}

const std::vector<Wrapper>& wrappers() {
  static const std::vector<Wrapper> all{
      {"python", "A Python package (ctypes, NumPy)", python_files},
      {"cpp", "A C++ header with std::span and Eigen maps", cpp_files},
      {"octave", "A MEX gateway for Octave and MATLAB", octave_files},
      {"ros2", "A ROS 2 package with the skeleton of a node", ros2_files},
      {"fmu", "An FMI 3 co-simulation unit of the moving mechanism", fmu_files},
      {"zephyr", "A Zephyr module", zephyr_files}};
  return all;
}

}  // namespace sinew

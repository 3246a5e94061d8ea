// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/model_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "identification/sha256.h"
#include "symbolic/functions.h"
#include "symbolic/read_mechanism.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Over names, sizes and contents of the files that make the model.
std::string hash_of(const fs::path& folder) {
  std::string all;
  for (const char* name : {"identified.toml", "mass_properties.csv", "mechanism.toml"}) {
    if (!fs::exists(folder / name)) continue;
    const std::string text = content(folder / name);
    all += fmt::format("{} {}\n{}", name, text.size(), text);
  }
  Sha256 hash;
  hash.update(all.data(), all.size());
  return hash.finish();
}

std::vector<std::string> joint_notes(const Mechanism& mechanism) {
  std::vector<std::string> notes{"Joint order (depth first from the base):"};
  int coordinate = 0;
  for (const Joint& joint : mechanism.joints)
    if (joint.type != JointType::fixed)
      notes.push_back(
          fmt::format("  q[{}] {} ({})", coordinate++, joint.name,
                      joint.type == JointType::revolute ? "revolute, rad" : "prismatic, m"));
  const Eigen::Vector3d& g = mechanism.gravity;
  notes.push_back(fmt::format("Gravity in the base frame: {}, {}, {} m/s^2.", g(0), g(1), g(2)));
  return notes;
}

}  // namespace

ModelFolder open_model_folder(const fs::path& folder) {
  ModelFolder result;
  result.mechanism = read_mechanism(folder);
  const Mechanism& m = result.mechanism;
  result.identity = {m.name, m.description.empty() ? "Model " + m.name : m.description,
                     hash_of(folder), joint_notes(m)};
  return result;
}

std::vector<Function> derive_functions(const ModelFolder& folder) {
  return functions_of(folder.mechanism, emitted_cost);
}

fs::path default_output(const ModelFolder& folder) {
  return fs::path("generated") / folder.mechanism.name;
}

Target target_named(const std::string& scalar) {
  if (scalar == "double") return {Scalar::binary64};
  if (scalar == "float") return {Scalar::binary32};
  throw std::invalid_argument(fmt::format("--scalar {}: expected double or float", scalar));
}

}  // namespace sinew

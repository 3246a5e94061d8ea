// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/models/model_folder.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "cli/models/model_set.h"
#include "generator/outputs/unfinished_run.h"
#include "identification/logs/sha256.h"
#include "simulation/plant/checked_extension.h"
#include "simulation/plant/learnt_model.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/extension/driven_model.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/extension/part_observation.h"
#include "symbolic/files/readable.h"
#include "symbolic/hand/read_hand.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/model/singular_mass_matrix.h"
#include "symbolic/tendons/functions.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

std::string described_files(const fs::path& folder) {
  std::string all;
  for (const char* name : {"hand.toml", "identified.toml", "mass_properties.csv", "mechanism.toml",
                           "names.toml", "part.toml"}) {
    if (!fs::exists(folder / name)) continue;
    const std::string text = read_whole(folder / name);
    all += fmt::format("{} {}\n{}", name, text.size(), text);
  }
  return all;
}

/// Over names, sizes and contents of the files that make the model.
std::string hash_of(const fs::path& folder, const std::vector<fs::path>& parts) {
  std::string all = described_files(folder);
  for (const fs::path& part : parts) all += described_files(part);
  Sha256 hash;
  hash.update(all.data(), all.size());
  return hash.finish();
}

/// Its words in lines as the header has them.
std::vector<std::string> in_lines(const std::string& text) {
  constexpr std::size_t width = 90;
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width)
      lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

std::vector<std::string> joint_notes(const Mechanism& mechanism) {
  std::vector<std::string> notes{"Joint order (depth first from the base):"};
  int coordinate = 0;
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    notes.push_back(
        fmt::format("  q[{}] {} ({}){}", coordinate++, joint.name,
                    joint.type == JointType::revolute ? "revolute, rad" : "prismatic, m",
                    joint.source_name.empty()
                        ? ""
                        : message_part(fmt::format(", '{}' in the source", joint.source_name))));
  }
  for (const JointCoupling& coupling : mechanism.couplings)
    notes.push_back(coupling.offset == 0.0
                        ? fmt::format("  {} = {} {} follows", coupling.dependent, coupling.ratio,
                                      coupling.independent)
                        : fmt::format("  {} = {} {} {} {} follows", coupling.dependent,
                                      coupling.ratio, coupling.independent,
                                      coupling.offset < 0.0 ? '-' : '+',
                                      std::abs(coupling.offset)));
  for (const FourBarCoupling& bars : mechanism.four_bars)
    notes.push_back(fmt::format("  {} follows {} by a four-bar", bars.dependent, bars.independent));
  const Eigen::Vector3d& g = mechanism.gravity;
  notes.push_back(fmt::format("Gravity in the base frame: {}, {}, {} m/s^2.", g(0), g(1), g(2)));
  return notes;
}

double reference_of(const Joint& joint) {
  return joint.reference.value_or(0.5 * (joint.low + joint.high));
}

NamedTendon named(const Tendon& tendon) {
  NamedTendon result{tendon.name};
  for (const PulleyRouting& pulley : tendon.pulleys) result.joints.push_back(pulley.joint);
  for (const StraightRouting& straight : tendon.straights)
    for (const std::string& body : {straight.from_body, straight.to_body})
      result.bodies.push_back(body);
  return result;
}

Naming naming_of(const Mechanism& mechanism) {
  Naming naming;
  const auto body_name = [&](int body) {
    return body < 0 ? std::string("base") : mechanism.bodies[static_cast<std::size_t>(body)].name;
  };
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    const bool turns = joint.type == JointType::revolute;
    naming.joints.push_back({joint.name, turns ? "revolute" : "prismatic", turns ? "rad" : "m",
                             body_name(joint.parent), body_name(index), joint.source_name,
                             joint.low, joint.high, reference_of(joint), joint.damping});
  }
  for (const Tendon& tendon : mechanism.tendons) naming.tendons.push_back(named(tendon));
  for (const Frame& frame : mechanism.frames) naming.frames.push_back({frame.name, frame.body});
  const Eigen::Vector3d& g = mechanism.gravity;
  naming.gravity = {g(0), g(1), g(2)};
  return naming;
}

/// Tendons by wrist channel.
Naming naming_of(const Hand& hand) {
  Naming naming;
  for (const std::string& name : coordinate_names(hand)) naming.joints.push_back({name});
  naming.wrist = {"q71", "q73"};
  naming.tendons.resize(hand.wrist.forearm_points.size());
  const auto place = [&](int channel, const std::string& name) {
    naming.tendons.at(static_cast<std::size_t>(channel)).name = name;
  };
  for (const HandFinger& finger : hand.fingers)
    for (std::size_t i = 0; i < finger.channels.size(); ++i)
      place(finger.channels[i], finger.mechanism.name + "." + finger.mechanism.tendons[i].name);
  for (std::size_t i = 0; i < hand.four_bar_channels.size(); ++i)
    place(hand.four_bar_channels[i], fmt::format("{}.h{}", hand.four_bar_name, i + 1));
  for (const HandFinger& finger : hand.fingers)
    if (!finger.mechanism.frames.empty())
      naming.frames.push_back({finger.mechanism.name + "." + finger.mechanism.frames[0].name,
                               finger.mechanism.name + "." + finger.mechanism.frames[0].body});
  return naming;
}

std::vector<std::string> coordinate_notes(const Hand& hand) {
  std::vector<std::string> notes{"Coordinates:"};
  int coordinate = 0;
  for (const std::string& name : coordinate_names(hand))
    notes.push_back(fmt::format("  q[{}] {} (rad)", coordinate++, name));
  notes.push_back("  q_wrist: q71, q73 (rad), the last two columns of every matrix");
  return notes;
}

}  // namespace

void recover_model(const fs::path& folder) {
  recover_interrupted(folder);
  for (const fs::path& part : parts_of(folder)) recover_interrupted(part);
  recover_interrupted(folder_of_motor(folder));
}

void add_model(Inputs& inputs, const fs::path& folder) {
  std::vector<fs::path> models = parts_of(folder);
  models.push_back(folder);
  models.push_back(folder_of_motor(folder));
  for (const fs::path& model : models)
    for (const char* name : {"channels.toml", "hand.toml", "identified.toml", "mass_properties.csv",
                             "mechanism.toml", "names.toml", "part.toml"})
      inputs.add(model / name);
}

ModelFolder open_model_folder(const fs::path& folder) {
  recover_model(folder);
  ModelFolder result;
  result.folder = folder;
  std::string description;
  std::vector<fs::path> parts;
  if (is_hand_folder(folder)) {
    HandDescription read = read_hand(folder);
    result.identified = checked_extension(folder, read.hand);
    result.identity.name = read.hand.name;
    description = read.hand.description;
    result.identity.notes = coordinate_notes(read.hand);
    result.identity.naming = naming_of(read.hand);
    parts = std::move(read.models);
    result.model = std::move(read.hand);
  } else if (is_part_folder(folder)) {
    const Part part = read_part(folder);
    const std::optional<Observation> observation = observation_of(part);
    const auto* motor = std::get_if<MotorParameters>(&part.parameters);
    result.identified = motor         ? checked_extension(folder, *motor)
                        : observation ? read_identified(folder, &*observation)
                                      : read_identified(folder, LearntPlaces());
    result.identity.name = part.name;
    description = part.description;
    result.model = part;
  } else {
    const Mechanism described = read_mechanism(folder);
    result.identified = checked_extension(folder, described);
    const Mechanism mechanism = with_identified(described, result.identified);
    if (speaks_of_motors(result.identified)) parts.push_back(folder_of_motor(folder));
    result.identity.name = mechanism.name;
    description = mechanism.description;
    result.identity.notes = joint_notes(mechanism);
    result.identity.naming = naming_of(mechanism);
    const auto note = is_massless(mechanism) ? std::optional(why_no_dynamics(mechanism))
                                             : note_of_singular_mass_matrix(mechanism);
    if (note) {
      result.remarks.push_back(*note);
      for (const std::string& line : in_lines("Note: " + *note))
        result.identity.notes.push_back(line);
    }
    result.model = mechanism;
  }
  // One line: it stands in comments of the emitted C and heads the report.
  result.identity.description =
      description.empty() ? "Model " + result.identity.name : message_part(description);
  result.identity.hash = hash_of(folder, parts);
  return result;
}

namespace {

/// effort and compensation of what logs taught; nothing where they taught nothing.
std::vector<Function> identified_functions(const ModelFolder& folder) {
  if (folder.identified.empty()) return {};
  DrivenModel driven;
  if (const Mechanism* mechanism = std::get_if<Mechanism>(&folder.model)) {
    driven = learnt_model(*mechanism, folder.identified, folder.folder);
  } else if (const Hand* hand = std::get_if<Hand>(&folder.model)) {
    driven = learnt_model(*hand, folder.identified);
  } else {
    const Part* part = std::get_if<Part>(&folder.model);
    if (part)
      if (const std::optional<Observation> observation = observation_of(*part))
        return {closed_observation(*observation, folder.identified)};
    const auto* motor = part ? std::get_if<MotorParameters>(&part->parameters) : nullptr;
    if (!motor)
      throw std::runtime_error(folder.identity.name +
                               ": identified.toml is understood beside a mechanism, a hand, a "
                               "motor, a lever, a tendon or a wrist");
    driven = driven_model(*motor, part->name);
  }
  std::vector<Function> functions{effort_function(driven, folder.identified)};
  Function compensation = compensation_function(driven, folder.identified);
  if (!compensation.outputs.empty()) functions.push_back(std::move(compensation));
  return functions;
}

std::vector<Function> model_functions(const ModelFolder& folder, bool runtime_parameters) {
  if (const Mechanism* mechanism = std::get_if<Mechanism>(&folder.model))
    return functions_of(*mechanism, emitted_cost, runtime_parameters);
  if (const Hand* hand = std::get_if<Hand>(&folder.model)) return hand_functions(*hand);
  return functions_of(std::get<Part>(folder.model));
}

}  // namespace

std::vector<Function> derive_functions(const ModelFolder& folder, bool runtime_parameters) {
  std::vector<Function> functions = model_functions(folder, runtime_parameters);
  for (Function& each : identified_functions(folder)) functions.push_back(std::move(each));
  return functions;
}

fs::path default_output(const ModelFolder& folder) {
  return fs::path("generated") / folder.identity.name;
}

Target target_named(const std::string& scalar, bool fused, const std::string& optimise) {
  if (scalar != "double" && scalar != "float")
    throw std::invalid_argument(fmt::format("--scalar {}: expected double or float", scalar));
  if (optimise != "speed" && optimise != "size")
    throw std::invalid_argument(fmt::format("--optimise {}: expected speed or size", optimise));
  return {scalar == "double" ? Scalar::binary64 : Scalar::binary32, fused,
          optimise == "size" ? Optimise::size : Optimise::speed};
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <stdexcept>

#include "simulation/simulate.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/parts/part.h"
#include "symbolic/hand/read_hand.h"
#include "symbolic/model/read_mechanism.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

template <typename Parameters>
Parameters part_beside(const fs::path& model, const char* name) {
  const fs::path folder = (model / "").lexically_normal().parent_path().parent_path() / name;
  if (!is_part_folder(folder))
    throw std::runtime_error(fmt::format("{}: not found; expected the {} of {} there",
                                         folder.string(), name, model.string()));
  const Part part = read_part(folder);
  if (const auto* found = std::get_if<Parameters>(&part.parameters)) return *found;
  throw std::runtime_error(
      fmt::format("{}: describes no {}", (folder / "part.toml").string(), name));
}

/// Motor, tendons and guides of a finger or a hand.
void add_drive_train(PlantParts& parts, const Scenario& scenario, const fs::path& model,
                     const fs::path& runtime) {
  const DriveMode mode = scenario.drive;
  if (mode == DriveMode::joint_torques) return;
  if (scenario.guiding == GuidingLaw::fitted)
    parts.guiding.emplace(scenario.guiding, part_beside<FittedGuiding>(model, "guiding").parameters,
                          runtime);
  if (scenario.guiding == GuidingLaw::capstan)
    parts.guiding.emplace(scenario.guiding,
                          part_beside<CapstanGuiding>(model, "capstan").parameters, runtime);
  if (mode == DriveMode::tendon_forces) return;
  parts.motor.emplace(part_beside<MotorParameters>(model, "motor"), scenario, runtime);
  parts.tendon.emplace(part_beside<TendonWithLever>(model, "tendon"), runtime);
}

void require_motor_mode(DriveMode mode, const fs::path& scenario) {
  if (mode != DriveMode::torque && mode != DriveMode::servo)
    throw std::runtime_error(
        fmt::format("{}: a motor alone is driven by torque or servo", scenario.string()));
}

Plant motor_plant(const fs::path& model, const fs::path& file, const fs::path& runtime) {
  const Part part = read_part(model);
  const auto* motor = std::get_if<MotorParameters>(&part.parameters);
  if (!motor)
    throw std::runtime_error(model.string() +
                             ": cannot be simulated; expected a motor, a mechanism or a hand");
  const DriveMode mode = read_drive_mode(file);
  require_motor_mode(mode, file);
  const Scenario scenario = read_scenario(file, channels_of(mode, {}, 0, TopOfModel::nothing));
  if (scenario.weight_feedforward)
    throw std::runtime_error(fmt::format(
        "{}: weight_feedforward needs tendons, which a motor alone has none of", file.string()));
  PlantParts parts;
  parts.motor.emplace(*motor, scenario, runtime);
  return Plant(scenario, std::move(parts));
}

Plant hand_plant(const fs::path& model, const fs::path& file, const fs::path& runtime) {
  const Hand hand = read_hand(model).hand;
  const DriveMode mode = read_drive_mode(file);
  const int channels = static_cast<int>(hand.wrist.forearm_points.size());
  const bool free = read_wrist_mode(file) == WristMode::dynamic;
  std::vector<JointChannel> joints;
  for (const std::string& name : coordinate_names(hand)) joints.push_back({name, false});
  if (free) joints.insert(joints.end(), {{"q71", false}, {"q73", false}});
  const Scenario scenario =
      read_scenario(file, channels_of(mode, joints, channels,
                                      free ? TopOfModel::nothing : TopOfModel::commanded_wrist));
  if (free && (scenario.wrist_feedforward || scenario.weight_feedforward))
    throw std::runtime_error(fmt::format(
        "{}: {} needs to know the wrist's motion; expected the wrist mode prescribed",
        file.string(), scenario.wrist_feedforward ? "wrist_feedforward" : "weight_feedforward"));
  PlantParts parts;
  const Eigen::Vector3d own_gravity = hand.fingers.front().mechanism.gravity;
  parts.joints = hand_joints(
      hand, scenario.gravity.value_or(own_gravity),
      {scenario.crank_inertia, free, scenario.wrist_inertia, scenario.wrist_damping}, runtime);
  if (!free) parts.wrist.emplace(hand.wrist, runtime);
  add_drive_train(parts, scenario, model, runtime);
  return Plant(scenario, std::move(parts));
}

Plant finger_plant(const fs::path& model, const fs::path& file, const fs::path& runtime) {
  Mechanism mechanism = read_mechanism(model);
  std::vector<JointChannel> joints;
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    joints.push_back({joint.name, joint.type == JointType::prismatic});
  }
  const DriveMode mode = read_drive_mode(file);
  const int tendons = static_cast<int>(mechanism.tendons.size());
  if (tendons == 0 && mode != DriveMode::joint_torques)
    throw std::runtime_error(
        fmt::format("{}: {} has no tendons; expected the drive mode joint_torques", file.string(),
                    mechanism.name));
  const Scenario scenario =
      read_scenario(file, channels_of(mode, joints, tendons, TopOfModel::fingertip));
  PlantParts parts;
  if (scenario.gravity) mechanism.gravity = *scenario.gravity;
  parts.joints = finger_joints(mechanism, runtime);
  add_drive_train(parts, scenario, model, runtime);
  return Plant(scenario, std::move(parts));
}

}  // namespace

Plant build_plant(const fs::path& model, const fs::path& scenario, const fs::path& runtime) {
  if (is_hand_folder(model)) return hand_plant(model, scenario, runtime);
  if (is_part_folder(model)) return motor_plant(model, scenario, runtime);
  return finger_plant(model, scenario, runtime);
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "simulation/plant/add_drives.h"
#include "simulation/plant/checked_extension.h"
#include "simulation/plant/simulate.h"
#include "symbolic/dynamics/coordinates.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/hand/read_hand.h"
#include "symbolic/model/read_mechanism.h"
#include "symbolic/parts/part.h"

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

/// What happens: a scenario's file, or what a program has put together.
class Happening {
 public:
  explicit Happening(fs::path file)
      : file_(std::move(file)), mode_(read_drive_mode(file_)), wrist_(read_wrist_mode(file_)) {}
  explicit Happening(const Scenario& scenario)
      : file_(scenario.file), mode_(scenario.drive), wrist_(scenario.wrist), given_(&scenario) {}

  std::string name() const { return file_.string(); }
  DriveMode mode() const { return mode_; }
  WristMode wrist() const { return wrist_; }
  std::vector<HeldJoint> held() const { return given_ ? given_->held : std::vector<HeldJoint>{}; }
  Scenario scenario(const ScenarioChannels& channels) const {
    return given_ ? *given_ : read_scenario(file_, channels);
  }

 private:
  fs::path file_;
  DriveMode mode_;
  WristMode wrist_;
  const Scenario* given_ = nullptr;
};

void require_motor_mode(const Happening& what) {
  if (what.mode() != DriveMode::torque && what.mode() != DriveMode::servo)
    throw std::runtime_error(
        fmt::format("{}: a motor alone is driven by torque or servo", what.name()));
}

Plant motor_plant(const fs::path& model, const Happening& what, const fs::path& runtime) {
  const Part part = read_part(model);
  const auto* motor = std::get_if<MotorParameters>(&part.parameters);
  if (!motor)
    throw std::runtime_error(model.string() +
                             ": cannot be simulated; expected a motor, a mechanism or a hand");
  require_motor_mode(what);
  const Scenario scenario = what.scenario(channels_of(what.mode(), {}, 0, TopOfModel::nothing));
  if (scenario.weight_feedforward)
    throw std::runtime_error(fmt::format(
        "{}: weight_feedforward needs tendons, which a motor alone has none of", what.name()));
  PlantParts parts;
  parts.motor.emplace(*motor, scenario, runtime);
  add_drives(with_losses(*motor, scenario), part.name, checked_extension(model, *motor), scenario,
             runtime, parts);
  return Plant(scenario, std::move(parts));
}

/// What logs taught of gravity, from the palm to the forearm frame.
Eigen::Vector3d learnt_gravity(const HeldHand& held, const Identified& identified) {
  return held.palm * (with_identified(held.mechanism, identified).gravity - held.mechanism.gravity);
}

/// A log is played on the hand that a diagnosis looks at: the palm held, its crank where
/// held_hand() has it. No tendon moves so much inertia.
void hold_palm(const Hand& hand, Scenario& scenario) {
  if (!hand.has_four_bar()) return;
  scenario.crank_inertia = 1e9;
  scenario.initial[coordinate_names(hand).back()] =
      0.5 * (hand.four_bar.theta2.low + hand.four_bar.theta2.high);
}

Plant hand_plant(const fs::path& model, const Happening& what, const fs::path& runtime) {
  const Hand described = read_hand(model).hand;
  const Identified identified = checked_extension(model, described);
  const Hand hand = with_identified(described, identified);
  const int channels = static_cast<int>(hand.wrist.forearm_points.size());
  const bool free = what.wrist() == WristMode::dynamic;
  std::vector<JointChannel> joints;
  for (const std::string& name : coordinate_names(hand)) joints.push_back({name, false, ""});
  if (free) joints.insert(joints.end(), {{"q71", false, ""}, {"q73", false, ""}});
  Scenario scenario = what.scenario(channels_of(
      what.mode(), joints, channels, free ? TopOfModel::nothing : TopOfModel::commanded_wrist));
  if (free && (scenario.wrist_feedforward || scenario.weight_feedforward))
    throw std::runtime_error(fmt::format(
        "{}: {} needs to know the wrist's motion; expected the wrist mode prescribed", what.name(),
        scenario.wrist_feedforward ? "wrist_feedforward" : "weight_feedforward"));
  if (scenario.as_logged) hold_palm(hand, scenario);
  PlantParts parts;
  // Taken exactly, which takes a while.
  const std::optional<HeldHand> held =
      identified.empty() && !scenario.as_logged ? std::nullopt : std::optional(held_hand(hand));
  Eigen::Vector3d own_gravity = hand.fingers.front().mechanism.gravity;
  if (held) own_gravity += learnt_gravity(*held, identified);
  parts.joints = hand_joints(
      hand, scenario.gravity.value_or(own_gravity),
      {scenario.crank_inertia, free, scenario.wrist_inertia, scenario.wrist_damping}, runtime);
  if (!free) parts.wrist.emplace(hand.wrist, runtime);
  add_drive_train(parts, scenario, model, runtime);
  if (held) add_drives(*held, identified, scenario, runtime, parts);
  return Plant(scenario, std::move(parts));
}

Plant finger_plant(const fs::path& model, const Happening& what, const fs::path& runtime) {
  const Mechanism described = read_mechanism(model);
  Identified identified = checked_extension(model, described);
  Mechanism mechanism = with_held(with_identified(described, identified), what.held());
  for (const HeldJoint& each : what.held())
    std::erase_if(identified.effects,
                  [&](const IdentifiedEffect& entry) { return entry.place == each.name; });
  std::vector<JointChannel> joints;
  const Coordinates coordinates(mechanism);
  for (const int index : coordinates.joints()) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    joints.push_back({joint.name, joint.type == JointType::prismatic, joint.source_name});
  }
  const int tendons = static_cast<int>(mechanism.tendons.size());
  if (tendons == 0 && what.mode() != DriveMode::joint_torques)
    throw std::runtime_error(
        fmt::format("{}: {} has no tendons; expected the drive mode joint_torques", what.name(),
                    mechanism.name));
  const Scenario scenario =
      what.scenario(channels_of(what.mode(), joints, tendons, TopOfModel::fingertip));
  PlantParts parts;
  if (scenario.gravity) mechanism.gravity = *scenario.gravity;
  parts.joints = finger_joints(mechanism, runtime);
  add_drive_train(parts, scenario, model, runtime);
  add_drives(mechanism, identified, scenario, model, runtime, parts);
  return Plant(scenario, std::move(parts));
}

Plant built_plant(const fs::path& model, const Happening& what, const fs::path& runtime) {
  if (is_hand_folder(model)) return hand_plant(model, what, runtime);
  if (is_part_folder(model)) return motor_plant(model, what, runtime);
  return finger_plant(model, what, runtime);
}

}  // namespace

Plant build_plant(const fs::path& model, const fs::path& scenario, const fs::path& runtime) {
  return built_plant(model, Happening(scenario), runtime);
}

Plant build_plant(const fs::path& model, const Scenario& scenario, const fs::path& runtime) {
  return built_plant(model, Happening(scenario), runtime);
}

}  // namespace sinew

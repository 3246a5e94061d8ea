// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/add_drives.h"

#include <algorithm>
#include <numeric>

#include "generator/assemble.h"
#include "simulation/plant/learnt_model.h"
#include "symbolic/extension/identified_mechanism.h"

namespace sinew {
namespace {

bool has_losses(const DrivenModel& model) {
  return std::any_of(model.joints.begin(), model.joints.end(), [](const DrivenJoint& joint) {
    return joint.friction != 0.0 || joint.armature != 0.0;
  });
}

/// Without the losses that the scenario leaves out.
void leave_out_losses(const Scenario& scenario, DrivenModel& model) {
  for (DrivenJoint& joint : model.joints) {
    if (joint.motor ? !scenario.motor_friction : !scenario.joint_damping) joint.damping = 0.0;
    if (joint.motor ? !scenario.motor_friction : !scenario.joint_friction) joint.friction = 0.0;
  }
}

/// What acts where tendons pull, or where motors move by themselves.
Identified acting_in(const Scenario& scenario, Identified identified) {
  const DriveMode mode = scenario.drive;
  const bool motors = mode == DriveMode::torque || mode == DriveMode::servo;
  std::erase_if(identified.effects, [&](const IdentifiedEffect& e) {
    const bool of_tendon = e.place.starts_with(tendon_place("")) || e.effect == "pulley_radius";
    return (of_tendon && mode == DriveMode::joint_torques) || (needs_motors(e) && !motors);
  });
  return identified;
}

}  // namespace

void add_drives(const MotorParameters& motor, const std::string& name, const Identified& identified,
                const Scenario& scenario, const std::filesystem::path& runtime, PlantParts& parts) {
  if (!identified.empty() || scenario.as_logged)
    parts.drives.emplace(driven_model(motor, name), identified, DriveSide{}, runtime);
}

void add_drives(const Mechanism& mechanism, const Identified& identified, const Scenario& scenario,
                const std::filesystem::path& model, const std::filesystem::path& runtime,
                PlantParts& parts) {
  const Identified acting = acting_in(scenario, identified);
  DrivenModel driven = learnt_model(mechanism, acting, model);
  if (acting.empty() && !has_losses(driven) && !scenario.as_logged) return;
  leave_out_losses(scenario, driven);
  parts.drive_tendons.resize(driven.tendons.names.size());
  std::iota(parts.drive_tendons.begin(), parts.drive_tendons.end(), 0);
  parts.drives.emplace(driven, acting, DriveSide{}, runtime);
}

void add_drives(const HeldHand& held, const Identified& identified, const Scenario& scenario,
                const std::filesystem::path& runtime, PlantParts& parts) {
  const Identified acting = acting_in(scenario, identified);
  if (acting.empty() && !scenario.as_logged) return;
  const bool tendons = scenario.drive != DriveMode::joint_torques;
  DrivenModel driven = tendons ? tendon_driven_model(held.mechanism, {}, emitted_cost)
                               : driven_model(held.mechanism, emitted_cost);
  leave_out_losses(scenario, driven);
  if (tendons) parts.drive_tendons = held.channels;
  parts.drives.emplace(driven, acting, DriveSide{.bodies = false, .as_read = false}, runtime);
}

Hand with_identified(Hand hand, const Identified& identified) {
  for (HandFinger& finger : hand.fingers) {
    const std::string joint = finger.mechanism.name + "_", link = "link " + joint;
    Identified own;
    for (IdentifiedEffect entry : identified.effects) {
      if (!changes_mechanism(entry)) continue;
      if (entry.place.starts_with(link))
        entry.place = "link " + entry.place.substr(link.size());
      else if (entry.place.starts_with(joint))
        entry.place.erase(0, joint.size());
      else
        continue;
      own.effects.push_back(std::move(entry));
    }
    finger.mechanism = with_identified(std::move(finger.mechanism), own);
  }
  return hand;
}

}  // namespace sinew

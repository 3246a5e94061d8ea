// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/logs/driven_request.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "generator/assemble.h"
#include "identification/subjects/driven_channels.h"
#include "identification/subjects/still_joints.h"
#include "simulation/plant/learnt_model.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/hand/hand_mechanism.h"

namespace sinew {
namespace {

using diagnosis::DiagnoseRequest;

/// What the first log has. Motors that another log lacks are left out, which is said.
diagnosis::LoggedEfforts efforts_of_all(const Mechanism& mechanism, DiagnoseRequest& request) {
  using diagnosis::LoggedEfforts;
  const LoggedEfforts common =
      diagnosis::logged_efforts(mechanism, request.logs.front(), request.map);
  if (common != LoggedEfforts::tendon_forces_and_motors) return common;
  for (const auto& group : {request.logs, request.holdout})
    for (const std::string& file : group)
      if (diagnosis::logged_efforts(mechanism, file, request.map) == LoggedEfforts::tendon_forces) {
        request.notes.push_back("the motors are left out: '" + file +
                                "' has no columns 'theta_1' and 'tau_1' of them");
        return LoggedEfforts::tendon_forces;
      }
  return common;
}

/// Joints by their own efforts, or by the forces of their tendons.
void set_robot(const std::filesystem::path& folder, const Mechanism& mechanism,
               DiagnoseRequest& request) {
  using diagnosis::LoggedEfforts;
  request.mechanism = mechanism;
  const LoggedEfforts logged = efforts_of_all(mechanism, request);
  if (logged == LoggedEfforts::at_joints) {
    request.kind = "robot";
    request.model = driven_model(mechanism, emitted_cost);
    request.channels = [mechanism, map = request.map](const std::string& file) {
      return diagnosis::robot_log_channels(mechanism, file, map);
    };
    return;
  }
  request.kind = "tendon-driven joints";
  const std::optional<MotorParameters> motor =
      logged == LoggedEfforts::tendon_forces_and_motors ? motor_beside(folder) : std::nullopt;
  request.model = tendon_driven_model(mechanism, motor, emitted_cost);
  request.channels = [mechanism, motors = motor.has_value()](const std::string&) {
    return diagnosis::tendon_log_channels(mechanism, diagnosis::tendon_numbers(mechanism), motors);
  };
}

/// With which the model's logs were read before. Others would spoil what those have taught.
void take_learnt_constants(DiagnoseRequest& request) {
  constexpr double same = 1e-6;  // of a constant that was written by hand
  for (const auto& [joint, learnt] : request.identified.torque_constants) {
    const double given = request.torque_constants.emplace(joint, learnt).first->second;
    if (std::abs(given / learnt - 1.0) > same)
      throw std::invalid_argument(fmt::format(
          "the torque constant of '{0}' is given as {1:.6g}, and identified.toml was learnt from "
          "currents with {2:.6g}: give that one, or start from the model without identified.toml",
          joint, given, learnt));
  }
}

/// An entry for no joint is a slip of the pen.
void check_constants(const DiagnoseRequest& request) {
  const diagnosis::DrivenChannels channels = request.channels(request.logs.front());
  for (const auto& [name, value] : request.torque_constants) {
    std::string joints;
    bool known = false;
    for (const std::string& effort : channels.efforts) {
      const std::string joint = diagnosis::joint_of_effort(effort);
      known = known || effort == name || joint == name;
      joints += (joints.empty() ? "" : ", ") + joint;
    }
    if (!known)
      throw std::invalid_argument("the torque constant of '" + name +
                                  "': there is no such joint; expected one of " + joints);
  }
}

/// The mechanism as the logs move it.
std::vector<HeldJoint> hold_still_joints(Mechanism& mechanism, DiagnoseRequest& request) {
  std::vector<std::string> files = request.logs;
  files.insert(files.end(), request.holdout.begin(), request.holdout.end());
  const std::vector<HeldJoint> held = diagnosis::still_joints(mechanism, files, request.map);
  for (const HeldJoint& each : held) {
    request.notes.push_back(diagnosis::said_of(each, mechanism));
    std::erase_if(request.identified.effects,
                  [&](const IdentifiedEffect& entry) { return entry.place == each.name; });
  }
  if (!held.empty()) mechanism = with_held(std::move(mechanism), held);
  return held;
}

/// All fingers of a hand by the forces of their tendons, the palm held.
void set_hand(const Hand& hand, const Identified& identified, DiagnoseRequest& request) {
  const HeldHand held = held_hand(hand);
  request.mechanism = with_identified(held.mechanism, identified);
  request.kind = "hand with a held palm";
  request.model = tendon_driven_model(*request.mechanism, {}, emitted_cost);
  std::vector<int> numbers;
  for (const int channel : held.channels) numbers.push_back(channel + 1);
  request.channels = [held, numbers](const std::string&) {
    diagnosis::DrivenChannels channels =
        diagnosis::tendon_log_channels(held.mechanism, numbers, false);
    for (std::size_t i = 0; i < held.coordinates.size(); ++i)
      channels.specs[i].name = channels.positions[i] = held.coordinates[i];
    return channels;
  };
}

}  // namespace

std::vector<HeldJoint> set_driven_model(const ModelFolder& folder, DiagnoseRequest& request) {
  take_learnt_constants(request);
  if (const Mechanism* mechanism = std::get_if<Mechanism>(&folder.model)) {
    Mechanism moving = *mechanism;
    std::vector<HeldJoint> held = hold_still_joints(moving, request);
    set_robot(folder.folder, moving, request);
    for (const HeldJoint& each : held) request.torque_constants.erase(each.name);
    check_constants(request);
    return held;
  }
  if (const Hand* hand = std::get_if<Hand>(&folder.model)) {
    set_hand(*hand, folder.identified, request);
    return {};
  }
  const Part* part = std::get_if<Part>(&folder.model);
  const MotorParameters* motor = part ? std::get_if<MotorParameters>(&part->parameters) : nullptr;
  if (!motor)
    throw std::runtime_error(
        folder.folder.string() +
        ": diagnose works on a mechanism of joints, a hand, a motor, a lever, a tendon or a wrist; "
        "this model is none of them");
  request.kind = "rotary drive";
  request.model = driven_model(*motor, part->name);
  request.channels = [](const std::string&) { return diagnosis::drive_log_channels(true); };
  return {};
}

}  // namespace sinew

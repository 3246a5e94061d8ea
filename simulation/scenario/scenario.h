// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be simulated: how long, how integrated, from which state, with which commands.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "simulation/scenario/signal.h"
#include "symbolic/files/description_error.h"
#include "symbolic/files/units.h"
#include "symbolic/model/held_joints.h"

namespace sinew {

enum class Integrator {
  cvode_bdf,      ///< SUNDIALS CVODE, stiff
  cvode_adams,    ///< SUNDIALS CVODE, not stiff, up to order 12
  fixed_step,     ///< linearly implicit Euler: one linear solution a step, as firmware would
  runge_kutta_4,  ///< fixed step, explicit
};

/// What moves the model.
enum class DriveMode {
  torque,         ///< motors with inertia; torque at their output shafts commanded
  servo,          ///< motors with inertia under a position controller; position commanded
  prescribed,     ///< motors follow the commanded position exactly
  tendon_forces,  ///< no motors: the forces of the tendons are commanded
  joint_torques,  ///< no tendons: joint torques are commanded
};

enum class GuidingLaw { none, fitted, capstan };

/// How the wrist of a hand moves.
enum class WristMode {
  prescribed,  ///< the palm follows the commanded flexion and abduction exactly
  dynamic,     ///< bars with inertia; torques on them commanded
};

/// Standard deviations of the white noise on each kind of output channel, SI units.
struct MeasurementNoise {
  unsigned long seed = 1;
  double position = 0.0;  ///< rad, joints
  double theta = 0.0;     ///< rad, motors
  double omega = 0.0;     ///< rad/s, motors
  double torque = 0.0;    ///< N·m, motors
  double force = 0.0;     ///< N, tendons
};

struct Scenario {
  std::string file;
  std::vector<std::string> tables;  ///< files of commands that it names
  double duration = 0.0;            ///< s
  double output_rate = 0.0;         ///< Hz
  /// m/s², instead of the model's: base frame of a finger, forearm frame of a hand.
  std::optional<Eigen::Vector3d> gravity;

  Integrator integrator = Integrator::cvode_bdf;
  double relative_tolerance = 1e-6;
  double absolute_tolerance = 1e-8;
  double step = 1.0 / 3000.0;  ///< s, of the fixed-step integrators

  DriveMode drive = DriveMode::torque;
  double gain = 0.0;                ///< N·m/rad, of the servo
  double rate_gain = 0.0;           ///< N·m·s/rad
  bool compensation = false;        ///< adds the emitted friction and ripple feedforward
  bool wrist_feedforward = false;   ///< adds the emitted wrist feedforward to motor positions
  bool weight_feedforward = false;  ///< motor positions also carry the bodies' weight
  double pretension = 0.0;          ///< N, of every tendon in the initial state

  bool motor_friction = true;
  bool motor_ripple = true;
  bool joint_damping = true;
  bool joint_friction = true;
  GuidingLaw guiding = GuidingLaw::none;
  double fixed_bending = 0.0;     ///< rad, bending of every tendon outside joints and wrist
  double crank_inertia = 2.0e-5;  ///< kg·m², of what the four-bar's crank moves (complete hand)

  WristMode wrist = WristMode::prescribed;
  double wrist_inertia = 2.0e-3;  ///< kg·m², of bars, palm and fingers about q71 and about q73
  double wrist_damping = 1.0e-2;  ///< N·m·s/rad, of q71 and of q73

  std::map<std::string, double> initial;   ///< channel (q20, qd_q20, theta_1, …) -> SI value
  std::map<std::string, Signal> commands;  ///< channel -> command, SI
  std::vector<HeldJoint> held;             ///< joints of a mechanism that do not move
  /// Efforts are those of a log: drives move by what was learnt, be it nothing.
  bool as_logged = false;
  double longest_step = 0.0;  ///< s, that still sees every sample; 0: no limit
  MeasurementNoise noise;
};

/// What a model can be told: the channels of commands and of the initial state.
struct ScenarioChannels {
  std::map<std::string, Dimension> commands;
  std::map<std::string, Dimension> initial;
  std::map<std::string, std::string> own_names{};  ///< of what has another name besides

  const std::string& own_name(const std::string& channel) const {
    const auto found = own_names.find(channel);
    return found == own_names.end() ? channel : found->second;
  }
};

/// The drive mode alone, which decides what the channels are. Throws DescriptionError.
DriveMode read_drive_mode(const std::filesystem::path& file);
/// The wrist's mode alone, for the same reason.
WristMode read_wrist_mode(const std::filesystem::path& file);

/// Reads a scenario (docs/simulation.md) and the CSV file of commands that it may name, relative to
/// itself. Throws DescriptionError with every mistake found, each with file, line and column: a
/// unit missing or of another kind, a value that is not finite, a channel that the model does not
/// have, time that does not rise.
Scenario read_scenario(const std::filesystem::path& file, const ScenarioChannels& channels);

}  // namespace sinew

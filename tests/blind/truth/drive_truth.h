// SPDX-License-Identifier: GPL-3.0-or-later
// A drive as it might really be: dynamic friction, two inertias, a sensor. Own equations and own
// integrator; nothing of the models or of the effect library is used.
#pragma once

#include <vector>

#include "tests/blind/truth/plant.h"
#include "tests/blind/truth/signals.h"

namespace sinew::truth {

/// What the model under test says about the drive, in rad and N·m or in m and N:
/// inertia * acceleration = effort - level * atan(shape * v) - viscous * v - load.
struct DriveModel {
  bool linear = false;
  bool loaded = false;  ///< the log has a load channel
  double inertia = 2.05e-3;
  double shape = 10.0;  ///< s/rad
  double level = 0.5586;
  double viscous = 0.0356;
  double motor_turn = 0.0628;  ///< output motion of one turn of the motor
  double output_turn = 6.283;  ///< of one turn of the output; 0 for a linear drive
  double amplitude = 2.0;      ///< of usual motions
  double top_speed = 4.0;
  double usual_load = 0.0;
};

/// What the drive has that its model has not. All zero: nothing.
struct DriveHidden {
  double friction_scale = 0.0;  ///< of the level
  double viscous_more = 0.0;
  double level_asymmetry = 0.0;  ///< level (1 + a sign v)
  double viscous_asymmetry = 0.0;
  double stribeck = 0.0, stribeck_speed = 0.1;
  double concave = 0.0;        ///< effort at the top speed, with the square root of speed
  double load_friction = 0.0;  ///< friction per load
  double output_ripple = 0.0, output_order = 1.0, output_phase = 0.0;
  double input_ripple = 0.0, input_order = 1.0, input_phase = 0.0;
  double load_ripple = 0.0, load_ripple_phase = 0.0;  ///< per load, once a motor turn
  double inertia_more = 0.0;
  double torque_gain = 0.0;  ///< true effort = (1 + g) * logged effort
  double offset = 0.0;
  double drift = 0.0, drift_time = 60.0;  ///< friction (1 + d (1 - exp(-t/T)))
  double compliance = 0.0;                ///< between motor and load inertia
  double backlash = 0.0;
  double delay = 0.0;  ///< s, the logged effort acts so much later
  double sensor_scale = 0.0, sensor_quantum = 0.0, sensor_lag = 0.0, sensor_play = 0.0;
  // Outside the library.
  double bump = 0.0, bump_at = 0.0, bump_width = 0.2;  ///< a tight spot
  double hum = 0.0, hum_rate = 30.0;                   ///< effort at a fixed frequency, rad/s
  double stop_stiffness = 0.0, stop_at = 1.0;          ///< a soft stop beyond a position
  double memory = 0.0;                                 ///< friction falls with the way since a turn
  double swing = 0.0, swing_time = 3.0;                ///< friction level waxes and wanes in time
};

struct DriveRun {
  Course course = Course::mixed;
  double seconds = 20.0, period = 1.0e-3;
  double load_mean = 0.0, load_swing = 0.0;
  bool bouc_wen = false;     ///< else LuGre
  double bristle = 4.0e-4;   ///< motion until friction is full
  double motor_share = 0.5;  ///< of the inertia, on the motor's side
};

/// Samples without measurement noise.
struct DriveSamples {
  std::vector<double> time, position, effort, reference, load;
};

/// What is the same in every run of one log: reference, known load, controller. Drawn once.
struct DriveCommand {
  std::vector<Reference> reference;  ///< at the integrator's steps
  std::vector<double> load, help;    ///< help: the controller's knowledge of the friction
  double stiffness = 0.0, damping = 0.0;
};

DriveCommand draw_command(const DriveModel& model, const DriveRun& run, Draw draw);

/// The same controller with another reference and load: columns of `motion` are the time, the
/// reference and, where there is one, the load.
DriveCommand followed_command(const DriveModel& model, const DriveRun& run,
                              const DriveCommand& controller, const Table& motion);

DriveSamples run_drive(const DriveModel& model, const DriveHidden& hidden, const DriveRun& run,
                       const DriveCommand& command);

/// Whether this build found MuJoCo.
bool mujoco_is_there();

/// The same by MuJoCo's mechanics and integrator, friction without memory. Knows friction_scale,
/// viscous_more, inertia_more, torque_gain, offset, both ripples, compliance and delay. Throws
/// std::runtime_error where this build has no MuJoCo.
DriveSamples run_drive_in_mujoco(const DriveModel& model, const DriveHidden& hidden,
                                 const DriveRun& run, const DriveCommand& command);

}  // namespace sinew::truth

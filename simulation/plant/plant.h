// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated system: motors, tendons and joints under the commands of a scenario.
//
// State y = [q (n), theta (k), qd (n), omega (k)], k motors with a state of their own.
// x_i = R theta_i + h_i(q, q_wrist) - const_i is a tendon's elongation (5.1).
#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/bodies/joints.h"
#include "simulation/drives/drive_train.h"
#include "simulation/drives/drives.h"
#include "simulation/drives/effort_history.h"
#include "simulation/drives/wrist_drive.h"
#include "simulation/plant/weight_feedforward.h"

namespace sinew {

/// Where power comes from or goes to [W]; losses are negative.
enum Power {
  motor_power,
  motor_friction_power,
  ripple_power,
  prescribed_power,  ///< of motors or tendon forces that follow a command exactly
  load_power,
  damping_power,
  guiding_power,
  external_power,
  wrist_power,
  base_power,
  effects_power,  ///< of the drives' friction and of all that logs taught
  power_count
};
using Powers = std::array<double, power_count>;
const char* name_of_power(int power);

/// Energy, kinetic, of gravity and elastic, and its rate by the chain rule.
struct EnergyNow {
  double value = 0.0;  ///< J
  double rate = 0.0;   ///< W, without the moving base: must equal the powers' sum
  double size = 0.0;   ///< W, sum of the sizes of the rate's parts: what rounding is relative to
};

/// What there is to simulate; anything may be absent. Copies share the compiled models.
struct PlantParts {
  std::shared_ptr<const Joints> joints;
  std::optional<MotorModel> motor;
  std::optional<TendonModel> tendon;
  std::optional<GuidingModel> guiding;
  std::optional<WristDrive> wrist;
  /// Of the first coordinates, and where they have as many, of the motors.
  std::optional<Drives> drives;
  std::vector<int> drive_tendons;  ///< the plant's number of each of the drives' tendons
};

/// Everything that follows from a state. To be used again and again: its arrays are kept.
struct Evaluation {
  Eigen::VectorXd q, qd, qdd;                       ///< n
  Eigen::VectorXd theta, omega;                     ///< one a motor
  Eigen::VectorXd theta_reference, reference_rate;  ///< rad, rad/s, one a motor
  Eigen::VectorXd command_torque;                   ///< N·m, without the feedforward
  MotorStates motor;                                ///< torque: with the feedforward
  Eigen::VectorXd h, h_rate, wrist_rate;            ///< one a tendon [m, m/s]
  Eigen::VectorXd elongation, finger_force;         ///< one a tendon [m, N]
  Eigen::VectorXd bending, inward;                  ///< one a tendon [rad; m/s towards the motor]
  TendonStates tendon;                              ///< force: on the motor's side
  Eigen::VectorXd external, joint_torque;           ///< on the joints: from outside; all [N·m]
  // As logged:
  Eigen::VectorXd logged_force;                    ///< one a tendon [N]
  Eigen::VectorXd logged_torque, logged_external;  ///< of the motors, on the joints [N·m]
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> P;
  double load = 0.0;           ///< N·m, against the motor
  double effects_power = 0.0;  ///< W, what the drives take; with rates only
  double base_power = 0.0;     ///< W, of the base's prescribed motion; with rates only
  bool has_rates = false;
  WristMotion wrist;

  const Eigen::VectorXd& force() const { return tendon.force; }
};

/// Coefficients of the motion linearised at a state, for n joints, m tendons and k motors:
///   M ddq = -K q - D dq - P^T (R k_t theta),
///   ddtheta = by_angle theta + by_speed dtheta - R/B k_t (R theta + P q).
struct MotionJacobian {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix mass, stiffness, damping;     ///< M, K (motors held), D: n x n, symmetric
  Matrix coupling;                     ///< P, m x n, where motors move
  Eigen::VectorXd tendon;              ///< k_t, m [N/m]
  Eigen::VectorXd by_angle, by_speed;  ///< of each motor, without its tendon [1/s², 1/s]
  double radius = 0.0;                 ///< R [m]
  double per_torque = 0.0;             ///< 1/B [1/(kg·m²)]
};

class Plant {
 public:
  Plant(const Scenario& scenario, PlantParts parts);
  Plant(const Plant&) = delete;  // commands are pointed to
  Plant(Plant&&) = default;

  int size() const { return 2 * (n_ + k_); }
  int coordinates() const { return n_; }
  int motors() const { return motors_; }
  int moving_motors() const { return k_; }  ///< motors with a state of their own
  int tendons() const { return tendons_; }
  const Joints* joints() const { return parts_.joints.get(); }
  const PlantParts& parts() const { return parts_; }
  const Scenario& scenario() const { return scenario_; }

  Eigen::VectorXd initial_state() const { return initial_; }
  /// `with_rates`: P and the tendons' velocities too, for powers and guiding friction.
  void evaluate(double time, const double* y, Evaluation& e, bool with_rates) const;
  /// What can be measured: all that a row of output shows, without the joints' accelerations unless
  /// they are known.
  const Evaluation& observed(double time, const double* y) const;
  /// As evaluate, or the last one where it was at the same time and state.
  const Evaluation& evaluated(double time, const double* y, bool with_rates) const;
  void derivative(double time, const double* y, double* dy) const;
  /// Without the gradients of gravity, Coriolis terms and bending.
  void jacobian(double time, const double* y, MotionJacobian& J) const;
  /// Torques [N·m] on the motors from now on, on top of the commanded ones; one a motor, drive mode
  /// torque. What a controller outside of the scenario gives.
  void hold_torque(const Eigen::VectorXd& torque) {
    held_torque_ = torque;
    scratch_time_ = -1.0;
  }
  /// To be called after each accepted step: the next lever searches start there.
  void accept(double time, const double* y);
  /// Where the drives' effects act through the instants before: `y` at `time` is the last one now,
  /// got to under the commands of the time `commanded` [s].
  void remember(double commanded, double time, const double* y);
  /// Effects that act through the instants before need to know how far the last one is away [s].
  void set_step(double seconds) {
    if (step_ != seconds) scratch_time_ = -1.0;
    step_ = seconds;
  }
  bool has_drives() const { return parts_.drives.has_value(); }
  /// Effects act through the instants before: only fixed steps integrate that.
  bool needs_steps() const { return parts_.drives && parts_.drives->needs_steps(); }
  /// The drives, as they are after the last accepted step.
  const Drives& drives() const { return *parts_.drives; }
  void set_past(const EffortPast& past) {
    parts_.drives->set_past(past);
    scratch_time_ = -1.0;
  }

  Powers powers(const Evaluation& e) const;
  EnergyNow energy(const Evaluation& e) const;

  /// Functions whose zeros are events, and what a zero means.
  std::vector<std::string> event_names() const;
  void events(double time, const double* y, double* values) const;
  /// Times at which commands jump, rising, within (0, duration).
  std::vector<double> jumps() const;

 private:
  using Matrix = MotionJacobian::Matrix;

  /// The wrist at the last time asked for: the commands of one time are needed again and again.
  struct WristNow {
    double time = -1.0;  ///< s; below 0: nothing yet
    WristMotion motion;
    Eigen::VectorXd feedforward, feedforward_rate;  ///< rad, rad/s, one a motor
  };

  void read_initial();
  /// Motors carry the weight from the start on; those that move start there unless told otherwise.
  void carry_weight();
  void take_commands(double time, Evaluation& e) const;
  void take_wrist(double time, Evaluation& e) const;
  void take_external(double time, Evaluation& e) const;
  void take_motor_commands(double time, Evaluation& e) const;
  void take_state(double time, const double* y, Evaluation& e) const;
  void take_paths(Evaluation& e, bool with_rates) const;
  bool is_evaluated(double time, const double* y) const;
  /// State, lengths and, where there are guides, velocities: what events depend on.
  const Evaluation& paths_at(double time, const double* y) const;
  void take_guiding(Evaluation& e) const;
  void take_motors(Evaluation& e) const;
  void take_readings(double time, Evaluation& e) const;
  double delay_of(int coordinate) const;
  /// Commanded forces are those that the sensors read.
  void take_true_forces(Evaluation& e) const;
  int driven_motors() const;
  DrivenInstant driven_instant(double time, const Evaluation& e) const;
  const OtherBodies* other_bodies(const Evaluation& e) const;
  /// Accelerations of what has drives.
  void take_drives(double time, Evaluation& e) const;
  void add_drive_slopes(double time, const Evaluation& e, MotionJacobian& J) const;
  double power_of_effects(const Evaluation& e) const;
  void motor_jacobian(const Evaluation& e, MotionJacobian& J) const;
  /// Adds what guides make of the joints' rates: P^T (dtension/d(dh/dt)) P.
  void add_guiding_slope(const Evaluation& e, MotionJacobian::Matrix& D) const;
  const Signal* command(const std::string& channel) const;
  const double* forces_or_zero(const Evaluation& e) const;

  Scenario scenario_;
  PlantParts parts_;
  int n_ = 0, k_ = 0, motors_ = 0, tendons_ = 0;
  bool elastic_ = false;  ///< tendons with lever, not commanded forces
  Eigen::VectorXd initial_, closure_, guess_, no_force_;
  Eigen::VectorXd damping_;            ///< of the coordinates that have no drives [N·m·s/rad]
  Eigen::VectorXd held_torque_;        ///< N·m, from outside; empty: none
  double step_ = 0.0;                  ///< s
  EffortHistory history_;              ///< torques of tendons, torques of motors, forces
  Eigen::VectorXd first_feedforward_;  ///< rad: motors start at 0 wherever the wrist starts
  std::vector<const Signal*> motor_command_, joint_command_, joint_load_, tension_command_,
      tip_command_;
  const Signal* load_ = nullptr;
  const Signal* flexion_ = nullptr;
  const Signal* abduction_ = nullptr;
  mutable Evaluation scratch_, path_scratch_, shown_;
  mutable double scratch_time_ = -1.0;  ///< s; below 0: nothing evaluated yet
  mutable Eigen::VectorXd scratch_state_;
  mutable WristNow wrist_now_;
  mutable WristTrack wrist_track_;
  mutable std::optional<WeightFeedforward> weight_;
  mutable Eigen::VectorXd inertial_, driven_guess_;  ///< for one call after the other
  mutable OtherBodies bodies_;
};

/// What else can be commanded.
enum class TopOfModel { nothing, fingertip, commanded_wrist };

/// A coordinate as scenarios name it.
struct JointChannel {
  std::string name;
  bool slides = false;        ///< m and N instead of rad and N·m
  std::string source_name{};  ///< in the file that the model was imported from; "" for the same
};

/// The channels that a scenario may command and set for a model of these parts.
ScenarioChannels channels_of(DriveMode mode, const std::vector<JointChannel>& joints, int tendons,
                             TopOfModel top);

}  // namespace sinew

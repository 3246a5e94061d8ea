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

#include "simulation/drive_train.h"
#include "simulation/joints.h"
#include "simulation/wrist_drive.h"

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
  power_count
};
using Powers = std::array<double, power_count>;
const char* name_of_power(int power);

/// A rate of energy [W], and the sum of its parts' sizes that rounding is relative to.
struct EnergyRate {
  double total = 0.0;
  double size = 0.0;
};

/// What there is to simulate; anything may be absent. Copies share the compiled models.
struct PlantParts {
  std::shared_ptr<const Joints> joints;
  std::optional<MotorModel> motor;
  std::optional<TendonModel> tendon;
  std::optional<GuidingModel> guiding;
  std::optional<WristDrive> wrist;
};

/// Everything that follows from a state.
struct Evaluation {
  Eigen::VectorXd q, qd, qdd;                ///< n
  Eigen::VectorXd theta, omega, omega_rate;  ///< one a motor
  Eigen::VectorXd theta_reference, torque;   ///< commanded; torque at the output shaft [N·m]
  Eigen::VectorXd h, h_rate, wrist_rate;     ///< one a tendon [m, m/s]
  Eigen::VectorXd elongation, force, finger_force, stiffness, lever_angle;
  Eigen::VectorXd tendon_torque, external;  ///< on the joints [N·m]
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> P;
  double load = 0.0;      ///< N·m, against the motor
  double residual = 0.0;  ///< m, largest of the emitted lever searches
  WristMotion wrist;
};

class Plant {
 public:
  Plant(const Scenario& scenario, PlantParts parts);

  int size() const { return 2 * (n_ + k_); }
  int coordinates() const { return n_; }
  int motors() const { return motors_; }
  int tendons() const { return tendons_; }
  const Joints* joints() const { return parts_.joints.get(); }
  const PlantParts& parts() const { return parts_; }
  const Scenario& scenario() const { return scenario_; }

  Eigen::VectorXd initial_state() const { return initial_; }
  /// `with_rates`: P and the tendons' velocities too, for powers and guiding friction.
  void evaluate(double time, const double* y, Evaluation& e, bool with_rates) const;
  void derivative(double time, const double* y, double* dy) const;
  /// d(derivative)/dy, size x size, without the gradients of gravity and Coriolis terms.
  void jacobian(double time, const double* y, Eigen::MatrixXd& J) const;
  /// To be called after each accepted step: the next lever searches start there.
  void accept(double time, const double* y);

  Powers powers(const Evaluation& e) const;
  /// Kinetic, of gravity and elastic [J].
  double energy(const Evaluation& e) const;
  /// d(energy)/dt by the chain rule [W] without the moving base: must equal the powers' sum.
  EnergyRate energy_rate(const Evaluation& e) const;

  /// Functions whose zeros are events, and what a zero means.
  std::vector<std::string> event_names() const;
  void events(double time, const double* y, double* values) const;
  /// Times at which commands jump, rising, within (0, duration).
  std::vector<double> jumps() const;

 private:
  void read_initial();
  void take_commands(double time, Evaluation& e) const;
  void take_tendons(Evaluation& e, bool with_rates) const;
  void take_guiding(Evaluation& e) const;
  /// Derivative of the finger-side tension by dh/dt, one a tendon [N·s/m].
  Eigen::VectorXd guiding_slope(const Evaluation& e) const;
  const Signal* command(const std::string& channel) const;

  Scenario scenario_;
  PlantParts parts_;
  int n_ = 0, k_ = 0, motors_ = 0, tendons_ = 0;
  bool elastic_ = false;  ///< tendons with lever, not commanded forces
  Eigen::VectorXd initial_, closure_, guess_;
  Eigen::VectorXd first_feedforward_;  ///< rad: motors start at 0 wherever the wrist starts
  std::vector<const Signal*> motor_command_, joint_command_, tip_command_;
  const Signal* load_ = nullptr;
  mutable Evaluation scratch_;
};

/// The channels that a scenario may command and set for a model of these parts.
ScenarioChannels channels_of(DriveMode mode, const std::vector<std::string>& joints, int tendons,
                             bool has_wrist);

}  // namespace sinew

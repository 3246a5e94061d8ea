// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sinew {
namespace {

using Eigen::VectorXd;

Eigen::Map<const VectorXd> part(const double* y, int first, int count) {
  return {y + first, count};
}

bool has_own_motors(DriveMode mode) {
  return mode == DriveMode::torque || mode == DriveMode::servo;
}

std::string motor_channel(DriveMode mode, const std::string& number) {
  const std::string suffix = number.empty() ? "" : "_" + number;
  if (mode == DriveMode::tendon_forces) return "force" + suffix;
  if (mode == DriveMode::torque) return number.empty() ? "tau_m" : "tau" + suffix;
  return number.empty() ? "theta_ref" : "theta" + suffix + "_ref";
}

std::string number_of(int index, bool single) {
  return single ? "" : fmt::format("{}", index + 1);
}

Dimension dimension_of(DriveMode mode) {
  if (mode == DriveMode::tendon_forces) return Dimension::force;
  return mode == DriveMode::torque ? Dimension::torque : Dimension::angle;
}

}  // namespace

const char* name_of_power(int power) {
  static constexpr const char* names[power_count] = {
      "motor",         "motor_friction", "ripple",   "prescribed", "load",
      "joint_damping", "guiding",        "external", "wrist",      "base"};
  return names[power];
}

ScenarioChannels channels_of(DriveMode mode, const std::vector<std::string>& joints, int tendons,
                             bool has_wrist) {
  ScenarioChannels channels;
  const bool drive_only = joints.empty();
  if (drive_only) channels.commands["load"] = Dimension::torque;
  const int motors = drive_only ? 1 : (mode == DriveMode::joint_torques ? 0 : tendons);
  for (int i = 0; i < motors; ++i) {
    const std::string number = number_of(i, drive_only);
    channels.commands[motor_channel(mode, number)] = dimension_of(mode);
    if (!has_own_motors(mode)) continue;
    channels.initial[drive_only ? "theta" : "theta_" + number] = Dimension::angle;
    channels.initial[drive_only ? "omega" : "omega_" + number] = Dimension::angular_velocity;
  }
  for (const std::string& joint : joints) {
    channels.commands["tau_" + joint] = Dimension::torque;
    channels.initial[joint] = Dimension::angle;
    channels.initial["qd_" + joint] = Dimension::angular_velocity;
  }
  if (has_wrist)
    for (const char* name : {"flexion", "abduction"}) channels.commands[name] = Dimension::angle;
  else if (!drive_only)
    for (const char* name : {"tip_force_x", "tip_force_y", "tip_force_z"})
      channels.commands[name] = Dimension::force;
  return channels;
}

Plant::Plant(const Scenario& scenario, PlantParts parts)
    : scenario_(scenario), parts_(std::move(parts)) {
  const DriveMode mode = scenario_.drive;
  const bool drive_only = !parts_.joints;
  n_ = drive_only ? 0 : parts_.joints->size();
  tendons_ = drive_only || mode == DriveMode::joint_torques ? 0 : parts_.joints->tendons;
  motors_ = drive_only ? 1 : (mode == DriveMode::tendon_forces ? 0 : tendons_);
  k_ = has_own_motors(mode) ? motors_ : 0;
  elastic_ = tendons_ > 0 && mode != DriveMode::tendon_forces;
  for (int i = 0; i < std::max(motors_, tendons_); ++i)
    motor_command_.push_back(command(motor_channel(mode, number_of(i, drive_only))));
  if (!drive_only) {
    for (const std::string& joint : parts_.joints->names)
      joint_command_.push_back(command("tau_" + joint));
    for (const char* name : {"tip_force_x", "tip_force_y", "tip_force_z"})
      tip_command_.push_back(command(name));
  }
  load_ = command("load");
  read_initial();
}

const Signal* Plant::command(const std::string& channel) const {
  const auto found = scenario_.commands.find(channel);
  return found == scenario_.commands.end() ? nullptr : &found->second;
}

void Plant::read_initial() {
  const auto value = [&](const std::string& name) {
    const auto found = scenario_.initial.find(name);
    return found == scenario_.initial.end() ? 0.0 : found->second;
  };
  initial_ = VectorXd::Zero(size());
  for (int j = 0; j < n_; ++j) {
    const std::string& joint = parts_.joints->names[static_cast<std::size_t>(j)];
    initial_(j) = value(joint);
    initial_(n_ + k_ + j) = value("qd_" + joint);
  }
  for (int i = 0; i < k_; ++i) {
    const std::string suffix = n_ == 0 ? "" : fmt::format("_{}", i + 1);
    initial_(n_ + i) = value("theta" + suffix);
    initial_(2 * n_ + k_ + i) = value("omega" + suffix);
  }
  closure_ = VectorXd::Zero(tendons_);
  if (!elastic_) return;
  guess_ = VectorXd::Constant(tendons_, parts_.tendon->free_angle());
  const double pretension = parts_.tendon->elongation_at(scenario_.pretension);
  Evaluation e;
  evaluate(0.0, initial_.data(), e, false);
  if (scenario_.wrist_feedforward && parts_.wrist) {
    first_feedforward_.resize(motors_);
    VectorXd rate(motors_);
    parts_.wrist->feedforward(e.wrist, first_feedforward_.data(), rate.data());
    evaluate(0.0, initial_.data(), e, false);
  }
  closure_ = e.elongation.array() - pretension;
  // The searches start within reach of the pretension.
  for (int i = 0; i < 10; ++i) accept(0.0, initial_.data());
}

void Plant::take_commands(double time, Evaluation& e) const {
  const auto at = [&](const Signal* signal) { return signal ? signal->at(time) : Sample{}; };
  if (parts_.wrist) e.wrist = parts_.wrist->at(at(command("flexion")), at(command("abduction")));
  e.load = at(load_).value;
  e.external.setZero(n_);
  if (n_ > 0) {
    double force[3];
    bool pushed = false;
    for (std::size_t i = 0; i < 3; ++i) {
      force[i] = at(tip_command_[i]).value;
      pushed = pushed || force[i] != 0.0;
    }
    if (pushed) parts_.joints->tip_torque(e.q.data(), force, e.external.data());
  }
  for (int j = 0; j < n_; ++j)
    e.external(j) += at(joint_command_[static_cast<std::size_t>(j)]).value;

  e.theta_reference.setZero(motors_);
  VectorXd reference_rate = VectorXd::Zero(motors_);
  if (scenario_.wrist_feedforward && parts_.wrist && motors_ > 0)
    parts_.wrist->feedforward(e.wrist, e.theta_reference.data(), reference_rate.data());
  if (first_feedforward_.size() > 0) e.theta_reference -= first_feedforward_;
  e.torque.setZero(motors_);
  for (int i = 0; i < motors_; ++i) {
    const Sample sample = at(motor_command_[static_cast<std::size_t>(i)]);
    if (scenario_.drive == DriveMode::torque) {
      e.torque(i) = sample.value;
    } else {
      e.theta_reference(i) += sample.value;
      reference_rate(i) += sample.rate;
    }
    if (scenario_.drive == DriveMode::servo)
      e.torque(i) = scenario_.gain * (e.theta_reference(i) - e.theta(i)) +
                    scenario_.rate_gain * (reference_rate(i) - e.omega(i));
    if (k_ > 0 && scenario_.compensation)
      e.torque(i) += parts_.motor->compensation(e.theta(i), e.omega(i));
  }
  if (k_ > 0) return;
  e.theta = e.theta_reference;
  e.omega = reference_rate;
}

void Plant::take_guiding(Evaluation& e) const {
  e.finger_force = e.force;
  if (!parts_.guiding) return;
  VectorXd bending(tendons_);
  parts_.joints->bending(e.q.data(), e.wrist, bending.data());
  for (int i = 0; i < tendons_; ++i)
    e.finger_force(i) = parts_.guiding->transmitted(
        e.force(i), bending(i) + scenario_.fixed_bending, -(e.h_rate(i) - e.wrist_rate(i)));
}

void Plant::take_tendons(Evaluation& e, bool with_rates) const {
  const Joints& joints = *parts_.joints;
  e.h.resize(tendons_);
  joints.lengths(e.q.data(), e.wrist, e.h.data());
  if (with_rates) {
    e.P.resize(tendons_, n_);
    e.wrist_rate.resize(tendons_);
    joints.coupling(e.q.data(), e.wrist, e.P.data(), e.wrist_rate.data());
    e.h_rate = e.P * e.qd + e.wrist_rate;
  }
  e.force.resize(tendons_);
  e.stiffness.setZero(tendons_);
  e.residual = 0.0;
  if (elastic_) {
    e.elongation = parts_.motor->radius() * e.theta + e.h - closure_;
    e.lever_angle.resize(tendons_);
    for (int i = 0; i < tendons_; ++i) {
      const TendonState state = parts_.tendon->at(e.elongation(i), guess_(i));
      e.force(i) = state.force;
      e.stiffness(i) = state.stiffness;
      e.lever_angle(i) = state.lever_angle;
      e.residual = std::max(e.residual, std::abs(state.residual));
    }
  }
}

void Plant::evaluate(double time, const double* y, Evaluation& e, bool with_rates) const {
  e.q = part(y, 0, n_);
  e.qd = part(y, n_ + k_, n_);
  e.theta = part(y, n_, k_);
  e.omega = part(y, 2 * n_ + k_, k_);
  take_commands(time, e);
  const bool rates = with_rates || parts_.guiding.has_value();
  e.tendon_torque.setZero(n_);
  if (tendons_ > 0) {
    take_tendons(e, rates);
    if (scenario_.drive == DriveMode::tendon_forces)
      for (int i = 0; i < tendons_; ++i) {
        const Signal* signal = motor_command_[static_cast<std::size_t>(i)];
        e.force(i) = scenario_.pretension + (signal ? signal->at(time).value : 0.0);
      }
    take_guiding(e);
    parts_.joints->torque(e.q.data(), e.wrist, e.finger_force.data(), e.tendon_torque.data());
  }
  e.qdd.resize(n_);
  if (n_ > 0) {
    VectorXd tau = e.tendon_torque + e.external;
    if (scenario_.joint_damping) tau -= parts_.joints->damping.cwiseProduct(e.qd);
    parts_.joints->acceleration(e.q.data(), e.qd.data(), e.wrist, tau.data(), e.qdd.data());
  }
  e.omega_rate.resize(k_);
  for (int i = 0; i < k_; ++i)
    e.omega_rate(i) = parts_.motor->acceleration(e.theta(i), e.omega(i), e.torque(i) - e.load,
                                                 tendons_ > 0 ? e.force(i) : 0.0);
}

void Plant::derivative(double time, const double* y, double* dy) const {
  evaluate(time, y, scratch_, false);
  Eigen::Map<VectorXd> rate(dy, size());
  rate.head(n_ + k_) = part(y, n_ + k_, n_ + k_);
  rate.segment(n_ + k_, n_) = scratch_.qdd;
  rate.tail(k_) = scratch_.omega_rate;
}

void Plant::accept(double time, const double* y) {
  if (!elastic_) return;
  evaluate(time, y, scratch_, false);
  guess_ = scratch_.lever_angle;
}

std::vector<std::string> Plant::event_names() const {
  std::vector<std::string> names;
  if (elastic_)
    for (int i = 0; i < tendons_; ++i) names.push_back(fmt::format("slack_{}", i + 1));
  if (parts_.guiding)
    for (int i = 0; i < tendons_; ++i) names.push_back(fmt::format("tendon_sticks_{}", i + 1));
  if (k_ > 0 && parts_.motor->sticking_speed() > 0.0)
    for (int i = 0; i < k_; ++i) names.push_back(fmt::format("motor_sticks_{}", i + 1));
  return names;
}

void Plant::events(double time, const double* y, double* values) const {
  Evaluation& e = scratch_;
  evaluate(time, y, e, false);
  if (elastic_)
    for (int i = 0; i < tendons_; ++i) *values++ = e.elongation(i);
  if (parts_.guiding) {
    const double limit = parts_.guiding->reversal_velocity();
    for (int i = 0; i < tendons_; ++i)
      *values++ = std::abs(e.h_rate(i) - e.wrist_rate(i)) / limit - 1.0;
  }
  const double speed = k_ > 0 ? parts_.motor->sticking_speed() : 0.0;
  if (speed > 0.0)
    for (int i = 0; i < k_; ++i) *values++ = std::abs(e.omega(i)) / speed - 1.0;
}

std::vector<double> Plant::jumps() const {
  std::vector<double> all;
  for (const auto& [ignored, signal] : scenario_.commands) signal.append_jumps(all);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  std::erase_if(all, [&](double t) { return t <= 0.0 || t >= scenario_.duration; });
  return all;
}

}  // namespace sinew

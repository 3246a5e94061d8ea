// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/plant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "symbolic/model/channel_name.h"

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
      "motor",   "motor_friction", "ripple", "prescribed", "load",   "joint_damping",
      "guiding", "external",       "wrist",  "base",       "effects"};
  return names[power];
}

namespace {

/// A joint's channels by its name in the file that the model was imported from.
void add_source_name(ScenarioChannels& channels, const std::string& name,
                     const std::string& source) {
  for (const std::string prefix : {"tau_", "qd_", ""}) {
    auto& known = prefix == "tau_" ? channels.commands : channels.initial;
    known.emplace(prefix + source, known.at(prefix + name));
    channels.own_names[prefix + source] = prefix + name;
  }
  channels.initial.emplace("q_" + source, channels.initial.at(name));
  channels.own_names["q_" + source] = name;
}

}  // namespace

ScenarioChannels channels_of(DriveMode mode, const std::vector<JointChannel>& joints, int tendons,
                             TopOfModel top) {
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
  for (const auto& [name, slides, source] : joints) {
    channels.commands["tau_" + name] = slides ? Dimension::force : Dimension::torque;
    for (const std::string& position : {name, position_channel(name)})
      channels.initial[position] = slides ? Dimension::length : Dimension::angle;
    channels.initial["qd_" + name] = slides ? Dimension::velocity : Dimension::angular_velocity;
    if (!source.empty()) add_source_name(channels, name, source);
  }
  if (top == TopOfModel::commanded_wrist)
    for (const char* name : {"flexion", "abduction"}) channels.commands[name] = Dimension::angle;
  // For a controller (simulation/loop): where it shall bring the joints.
  if (top == TopOfModel::commanded_wrist && mode == DriveMode::torque)
    for (const JointChannel& joint : joints)
      channels.commands[joint.name + "_ref"] = joint.slides ? Dimension::length : Dimension::angle;
  if (top == TopOfModel::fingertip)
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
    for (const std::string& joint : parts_.joints->names) {
      joint_command_.push_back(command("tau_" + joint));
      joint_load_.push_back(command("load_" + joint));
    }
    for (const char* name : {"tip_force_x", "tip_force_y", "tip_force_z"})
      tip_command_.push_back(command(name));
  }
  if (!drive_only && scenario_.joint_damping) damping_ = parts_.joints->damping;
  damping_.conservativeResizeLike(VectorXd::Zero(n_));
  if (parts_.drives) damping_.head(parts_.drives->coordinates() - driven_motors()).setZero();
  step_ = scenario_.step;
  for (int t = 0; parts_.drives && t < parts_.drives->tendons(); ++t)
    tension_command_.push_back(command(fmt::format("tension_{}", t + 1)));
  load_ = command("load");
  flexion_ = command("flexion");
  abduction_ = command("abduction");
  no_force_.setZero(k_);
  read_initial();
}

const Signal* Plant::command(const std::string& channel) const {
  const auto found = scenario_.commands.find(channel);
  return found == scenario_.commands.end() ? nullptr : &found->second;
}

void Plant::read_initial() {
  const auto value = [&](const std::string& name, double otherwise = 0.0) {
    const auto found = scenario_.initial.find(name);
    return found == scenario_.initial.end() ? otherwise : found->second;
  };
  initial_ = VectorXd::Zero(size());
  for (int j = 0; j < n_; ++j) {
    const std::string& joint = parts_.joints->names[static_cast<std::size_t>(j)];
    initial_(j) = value(joint, value(position_channel(joint), parts_.joints->rest(j)));
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
    first_feedforward_ = wrist_now_.feedforward;
    evaluate(0.0, initial_.data(), e, false);
  }
  closure_ = e.elongation.array() - pretension;
  if (scenario_.weight_feedforward) carry_weight();
  // The searches start within reach of the pretension.
  for (int i = 0; i < 10; ++i) {
    scratch_time_ = -1.0;  // to be evaluated again, from the new guess
    accept(0.0, initial_.data());
  }
  scratch_time_ = -1.0;
}

void Plant::carry_weight() {
  weight_.emplace(parts_, initial_.head(n_), scenario_.pretension);
  VectorXd angle = VectorXd::Zero(motors_), rate = angle;
  weight_->add(parts_, flexion_, abduction_, 0.0, angle, rate);
  for (int i = 0; i < k_; ++i)
    if (!scenario_.initial.contains(fmt::format("theta_{}", i + 1))) initial_(n_ + i) = angle(i);
}

void Plant::take_guiding(Evaluation& e) const {
  if (!parts_.guiding) {
    e.finger_force = e.force();
    return;
  }
  e.bending.resize(tendons_);
  e.finger_force.resize(tendons_);
  parts_.joints->bending(e.q.data(), e.wrist, e.bending.data());
  e.bending.array() += scenario_.fixed_bending;
  e.inward = e.wrist_rate - e.h_rate;
  parts_.guiding->transmitted(tendons_, e.force().data(), e.bending.data(), e.inward.data(),
                              e.finger_force.data());
}

void Plant::take_paths(Evaluation& e, bool with_rates) const {
  const Joints& joints = *parts_.joints;
  e.h.resize(tendons_);
  joints.lengths(e.q.data(), e.wrist, e.h.data());
  if (with_rates) {
    e.P.resize(tendons_, n_);
    e.wrist_rate.resize(tendons_);
    e.h_rate.resize(tendons_);
    joints.coupling(e.q.data(), e.wrist, e.P.data(), e.wrist_rate.data());
    const double* P = e.P.data();
    for (int i = 0; i < tendons_; ++i) {
      double rate = e.wrist_rate(i);
      for (int j = 0; j < n_; ++j) rate += *P++ * e.qd(j);
      e.h_rate(i) = rate;
    }
  }
  if (elastic_) e.elongation = parts_.motor->radius() * e.theta + e.h - closure_;
}

const double* Plant::forces_or_zero(const Evaluation& e) const {
  return tendons_ > 0 ? e.force().data() : no_force_.data();
}

void Plant::take_state(double time, const double* y, Evaluation& e) const {
  e.q = part(y, 0, n_);
  e.qd = part(y, n_ + k_, n_);
  e.theta = part(y, n_, k_);
  e.omega = part(y, 2 * n_ + k_, k_);
  take_commands(time, e);
}

const Evaluation& Plant::observed(double time, const double* y) const {
  if (is_evaluated(time, y)) return scratch_;
  take_state(time, y, shown_);
  if (tendons_ > 0) take_paths(shown_, false);
  if (elastic_) {
    // Rows follow each other closely: the last row's angles are nearer than the last step's.
    const VectorXd& last = shown_.tendon.lever_angle;
    parts_.tendon->at(tendons_, shown_.elongation.data(),
                      last.size() > 0 ? last.data() : guess_.data(), shown_.tendon);
  }
  take_motors(shown_);
  take_readings(time, shown_);
  return shown_;
}

void Plant::take_motors(Evaluation& e) const {
  if (k_ > 0)
    parts_.motor->at(k_, e.theta.data(), e.omega.data(), e.command_torque.data(), forces_or_zero(e),
                     e.load, scenario_.compensation, e.motor);
  else
    e.motor.torque.setZero(motors_);
}

void Plant::evaluate(double time, const double* y, Evaluation& e, bool with_rates) const {
  take_state(time, y, e);
  e.has_rates = with_rates;
  e.joint_torque = e.external;
  if (tendons_ > 0) {
    take_paths(e, with_rates || parts_.guiding.has_value());
    if (elastic_) parts_.tendon->at(tendons_, e.elongation.data(), guess_.data(), e.tendon);
    take_guiding(e);
    parts_.joints->torque(e.q.data(), e.wrist, e.finger_force.data(), e.joint_torque.data());
    e.joint_torque += e.external;
  }
  take_motors(e);
  take_readings(time, e);
  if (n_ > 0) {
    e.qdd.resize(n_);
    e.joint_torque -= damping_.cwiseProduct(e.qd);
    if (!parts_.drives)
      parts_.joints->acceleration(e.q.data(), e.qd.data(), e.wrist, e.joint_torque.data(),
                                  e.qdd.data());
  }
  if (parts_.drives) take_drives(time, e);
  if (n_ > 0 && with_rates)
    e.base_power = parts_.joints->base_power(e.q.data(), e.qd.data(), e.qdd.data(), e.wrist);
  if (parts_.drives && with_rates) e.effects_power = power_of_effects(e);
}

bool Plant::is_evaluated(double time, const double* y) const {
  const auto bytes = static_cast<std::size_t>(size()) * sizeof(double);
  return time == scratch_time_ && std::memcmp(y, scratch_state_.data(), bytes) == 0;
}

const Evaluation& Plant::evaluated(double time, const double* y, bool with_rates) const {
  if (is_evaluated(time, y) && (scratch_.has_rates || !with_rates)) return scratch_;
  scratch_time_ = -1.0;  // stays so where the evaluation throws
  evaluate(time, y, scratch_, with_rates);
  scratch_state_ = part(y, 0, size());
  scratch_time_ = time;
  return scratch_;
}

void Plant::derivative(double time, const double* y, double* dy) const {
  const Evaluation& e = evaluated(time, y, false);
  Eigen::Map<VectorXd> rate(dy, size());
  rate.head(n_ + k_) = part(y, n_ + k_, n_ + k_);
  rate.segment(n_ + k_, n_) = e.qdd;
  if (k_ > 0) rate.tail(k_) = e.motor.acceleration;
}

void Plant::accept(double time, const double* y) {
  if (elastic_) guess_ = evaluated(time, y, false).tendon.lever_angle;
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
  const Evaluation& e = is_evaluated(time, y) ? scratch_ : paths_at(time, y);
  if (elastic_) values = std::copy(e.elongation.begin(), e.elongation.end(), values);
  if (parts_.guiding) {
    const double limit = parts_.guiding->reversal_velocity();
    for (int i = 0; i < tendons_; ++i)
      *values++ = std::abs(e.h_rate(i) - e.wrist_rate(i)) / limit - 1.0;
  }
  const double speed = k_ > 0 ? parts_.motor->sticking_speed() : 0.0;
  if (speed > 0.0)
    for (int i = 0; i < k_; ++i) *values++ = std::abs(e.omega(i)) / speed - 1.0;
}

const Evaluation& Plant::paths_at(double time, const double* y) const {
  take_state(time, y, path_scratch_);
  if (tendons_ > 0) take_paths(path_scratch_, parts_.guiding.has_value());
  return path_scratch_;
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

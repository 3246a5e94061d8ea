// SPDX-License-Identifier: GPL-3.0-or-later
// What the scenario commands at a time, put where an evaluation wants it.
#include "simulation/plant/plant.h"

namespace sinew {
namespace {

Sample at(const Signal* signal, double time) {
  return signal ? signal->at(time) : Sample{};
}

}  // namespace

void Plant::take_wrist(double time, Evaluation& e) const {
  if (!parts_.wrist) return;
  const bool moves = flexion_ || abduction_;
  const bool known = wrist_now_.time >= 0.0 && (!moves || wrist_now_.time == time);
  if (!known) {
    wrist_now_.time = -1.0;  // stays so where the wrist cannot get there
    wrist_now_.motion = wrist_track_.at(*parts_.wrist, flexion_, abduction_, time);
    if (scenario_.wrist_feedforward && motors_ > 0) {
      wrist_now_.feedforward.resize(motors_);
      wrist_now_.feedforward_rate.resize(motors_);
      parts_.wrist->feedforward(wrist_now_.motion, wrist_now_.feedforward.data(),
                                wrist_now_.feedforward_rate.data());
    }
    wrist_now_.time = time;
  }
  e.wrist = wrist_now_.motion;
}

void Plant::take_external(double time, Evaluation& e) const {
  e.external.setZero(n_);
  if (n_ == 0) return;
  double force[3];
  bool pushed = false;
  for (std::size_t i = 0; i < 3; ++i) {
    force[i] = at(tip_command_[i], time).value;
    pushed = pushed || force[i] != 0.0;
  }
  if (pushed) parts_.joints->tip_torque(e.q.data(), force, e.external.data());
  for (int j = 0; j < n_; ++j)
    e.external(j) += at(joint_command_[static_cast<std::size_t>(j)], time - delay_of(j)).value;
}

void Plant::take_motor_commands(double time, Evaluation& e) const {
  e.command_torque.setZero(motors_);
  if (scenario_.drive == DriveMode::torque) {
    e.theta_reference.setZero(motors_);
    for (int i = 0; i < motors_; ++i)
      e.command_torque(i) =
          at(motor_command_[static_cast<std::size_t>(i)], time - delay_of(n_ + i)).value;
    if (held_torque_.size() == motors_) e.command_torque += held_torque_;
    return;
  }
  if (wrist_now_.feedforward.size() > 0) {
    e.theta_reference = wrist_now_.feedforward;
    if (first_feedforward_.size() > 0) e.theta_reference -= first_feedforward_;
    e.reference_rate = wrist_now_.feedforward_rate;
  } else {
    e.theta_reference.setZero(motors_);
    e.reference_rate.setZero(motors_);
  }
  if (weight_)
    weight_->add(parts_, flexion_, abduction_, time, e.theta_reference, e.reference_rate);
  for (int i = 0; i < motors_; ++i) {
    const Sample sample = at(motor_command_[static_cast<std::size_t>(i)], time);
    e.theta_reference(i) += sample.value;
    e.reference_rate(i) += sample.rate;
  }
  if (scenario_.drive == DriveMode::servo)
    e.command_torque = scenario_.gain * (e.theta_reference - e.theta) +
                       scenario_.rate_gain * (e.reference_rate - e.omega);
}

void Plant::take_commands(double time, Evaluation& e) const {
  take_wrist(time, e);
  e.load = at(load_, time).value;
  take_external(time, e);
  if (scenario_.drive == DriveMode::tendon_forces) {
    e.tendon.force.resize(tendons_);
    e.tendon.stiffness.setZero(tendons_);
    for (int i = 0; i < tendons_; ++i)
      e.tendon.force(i) =
          scenario_.pretension + at(motor_command_[static_cast<std::size_t>(i)], time).value;
    take_true_forces(e);
  }
  take_motor_commands(time, e);
  if (k_ > 0) return;
  e.theta = e.theta_reference;
  e.omega = e.reference_rate;
}

}  // namespace sinew

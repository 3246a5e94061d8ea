// SPDX-License-Identifier: GPL-3.0-or-later
// The plant's coordinates that have drives, and what is logged of their efforts.
#include <cmath>

#include "simulation/plant/plant.h"

namespace sinew {

using Eigen::VectorXd;

namespace {

VectorXd joined(const VectorXd& joints, const VectorXd& motors, int count) {
  VectorXd all(joints.size() + count);
  all.head(joints.size()) = joints;
  all.tail(count) = motors.head(count);
  return all;
}

}  // namespace

/// Motors among the coordinates of the drives: all, or none.
int Plant::driven_motors() const {
  return parts_.drives && parts_.drives->coordinates() > parts_.drives->joints() ? k_ : 0;
}

/// The last of the drives' coordinates are the motors'.
double Plant::delay_of(int coordinate) const {
  if (!parts_.drives) return 0.0;
  const std::vector<double>& delays = parts_.drives->delays();
  const auto at = static_cast<std::size_t>(coordinate);
  return at < delays.size() ? delays[at] : 0.0;
}

DrivenInstant Plant::driven_instant(double time, const Evaluation& e) const {
  const int motors = driven_motors();
  DrivenInstant now{time,
                    step_,
                    joined(e.q, e.theta, motors),
                    joined(e.qd, e.omega, motors),
                    joined(e.joint_torque, e.motor.torque, motors),
                    VectorXd::Zero(n_ + motors),
                    {}};
  if (joint_load_.size() == static_cast<std::size_t>(n_))
    for (int j = 0; j < n_; ++j)
      if (const Signal* load = joint_load_[static_cast<std::size_t>(j)])
        now.load(j) = load->at(time).value;
  now.load.tail(motors).setConstant(e.load);
  if (tendons_ > 0 && motors > 0) now.load.tail(motors) += parts_.motor->radius() * e.force();
  now.tension.setZero(parts_.drives->tendons());
  for (Eigen::Index t = 0; t < now.tension.size(); ++t) {
    const auto tendon = static_cast<std::size_t>(t);
    if (tendon < parts_.drive_tendons.size())
      now.tension(t) = e.logged_force(parts_.drive_tendons[tendon]);
    else if (tension_command_[tendon])
      now.tension(t) = tension_command_[tendon]->at(time).value;
  }
  // Commands are asked for at their own time; what follows from the state is remembered.
  for (int c = 0; c < n_ + motors; ++c) {
    const double delay = delay_of(c);
    if (delay <= 0.0) continue;
    if (c < n_ && tendons_ > 0) {
      const VectorXd present = e.joint_torque - e.external;
      now.effort(c) += history_.at(PastEffort::joint_torque, time - delay, present)(c) - present(c);
    }
    if (c >= n_ && scenario_.drive == DriveMode::servo)
      now.effort(c) = history_.at(PastEffort::motor_torque, time - delay, e.motor.torque)(c - n_);
  }
  return now;
}

const OtherBodies* Plant::other_bodies(const Evaluation& e) const {
  if (parts_.drives->with_bodies()) return nullptr;
  const VectorXd nothing = VectorXd::Zero(n_);
  bodies_.mass.resize(n_, n_);
  bodies_.free.resize(n_);
  parts_.joints->mass_matrix(e.q.data(), e.wrist, bodies_.mass.data());
  parts_.joints->acceleration(e.q.data(), e.qd.data(), e.wrist, nothing.data(),
                              bodies_.free.data());
  return &bodies_;
}

void Plant::take_drives(double time, Evaluation& e) const {
  const int motors = driven_motors();
  parts_.drives->accelerations(driven_instant(time, e), other_bodies(e), driven_guess_);
  e.qdd = driven_guess_.head(n_);
  if (motors == 0) return;
  e.motor.acceleration = driven_guess_.tail(motors);
  e.motor.friction_power = e.motor.ripple_power = 0.0;
}

/// All that acts on the coordinates and moves no body.
double Plant::power_of_effects(const Evaluation& e) const {
  double power = 0.0;
  if (n_ > 0) {
    VectorXd taken(n_);
    parts_.joints->inertial_forces(e.q.data(), e.qd.data(), e.qdd.data(), e.wrist, taken.data());
    power = e.qd.dot(taken - e.joint_torque);
  }
  if (driven_motors() == 0) return power;
  VectorXd acting = e.motor.torque.array() - e.load;
  if (tendons_ > 0) acting -= parts_.motor->radius() * e.force();
  return power + e.omega.dot(parts_.motor->inertia() * e.motor.acceleration - acting);
}

void Plant::add_drive_slopes(double time, const Evaluation& e, MotionJacobian& J) const {
  const int motors = driven_motors(), joints = parts_.drives->coordinates() - motors;
  const DrivenSlopes slopes =
      parts_.drives->slopes(driven_instant(time, e), joined(e.qdd, e.motor.acceleration, motors));
  const auto symmetric = [&](const OtherBodies::Matrix& all) {
    const auto own = all.topLeftCorner(joints, joints);
    return OtherBodies::Matrix(0.5 * (own + own.transpose()));
  };
  if (joints > 0) {
    if (parts_.drives->with_bodies()) J.mass.setZero();
    J.mass.topLeftCorner(joints, joints) += symmetric(slopes.by_acceleration);
    J.damping.topLeftCorner(joints, joints) += symmetric(slopes.by_velocity);
    J.stiffness.topLeftCorner(joints, joints) += symmetric(slopes.by_position);
  }
  const bool servo = scenario_.drive == DriveMode::servo;
  for (int i = 0; i < motors; ++i) {
    const double inertia = slopes.by_acceleration(n_ + i, n_ + i);
    J.by_angle(i) =
        -(slopes.by_position(n_ + i, n_ + i) + (servo ? scenario_.gain : 0.0)) / inertia;
    J.by_speed(i) =
        -(slopes.by_velocity(n_ + i, n_ + i) + (servo ? scenario_.rate_gain : 0.0)) / inertia;
  }
}

void Plant::take_readings(double time, Evaluation& e) const {
  e.logged_torque = e.motor.torque;
  e.logged_external = e.external;
  e.logged_force = e.force();
  if (!parts_.drives) return;
  const std::vector<ForceSensor>& sensors = parts_.drives->force_sensors();
  for (std::size_t t = 0; t < parts_.drive_tendons.size() && tendons_ > 0; ++t) {
    double& force = e.logged_force(parts_.drive_tendons[t]);
    force = sensors[t].reading(force);
  }
  const auto command = [&](const Signal* signal, int coordinate) {
    return signal ? signal->at(time).value - signal->at(time - delay_of(coordinate)).value : 0.0;
  };
  for (int j = 0; j < n_ && tendons_ == 0; ++j)
    e.logged_external(j) += command(joint_command_[static_cast<std::size_t>(j)], j);
  for (int i = 0; i < driven_motors(); ++i) {
    const double delay = delay_of(n_ + i);
    if (scenario_.drive == DriveMode::torque)
      e.logged_torque(i) += command(motor_command_[static_cast<std::size_t>(i)], n_ + i);
    else if (delay < 0.0)
      e.logged_torque(i) = history_.at(PastEffort::motor_torque, time + delay, e.motor.torque)(i);
  }
}

void Plant::take_true_forces(Evaluation& e) const {
  if (!parts_.drives) return;
  for (std::size_t t = 0; t < parts_.drive_tendons.size(); ++t) {
    double& force = e.tendon.force(parts_.drive_tendons[t]);
    force = parts_.drives->force_sensors()[t].force(force);
  }
}

void Plant::remember(double commanded, double time, const double* y) {
  if (!needs_steps()) return;
  const Evaluation& e = evaluated(commanded, y, false);
  parts_.drives->remember(driven_instant(commanded, e),
                          joined(e.qdd, e.motor.acceleration, driven_motors()));
  double longest = 0.0;
  for (const double delay : parts_.drives->delays()) longest = std::max(longest, std::abs(delay));
  history_.add(time, {e.joint_torque - e.external, e.motor.torque, e.force()}, longest);
  scratch_time_ = -1.0;  // the same state moves on otherwise now
}

}  // namespace sinew

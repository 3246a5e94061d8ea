// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/truth/drive_truth.h"

#include <algorithm>
#include <cmath>

namespace sinew::truth {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int inner_steps = 4;

// Effort of a logged signal that acts later: a ring of past values, read between two of them.
class DelayLine {
 public:
  DelayLine(double delay, double step)
      : back_(delay / step), ring_(static_cast<size_t>(back_) + 3) {}
  double pass(double value) {
    if (back_ <= 0.0) return value;
    ring_[at_ % ring_.size()] = value;
    const auto whole = static_cast<size_t>(back_);
    const double part = back_ - static_cast<double>(whole);
    const auto read = [&](size_t n) {
      return at_ >= n ? ring_[(at_ - n) % ring_.size()] : ring_[0];
    };
    const double late = (1.0 - part) * read(whole) + part * read(whole + 1);
    ++at_;
    return late;
  }

 private:
  double back_;
  std::vector<double> ring_;
  size_t at_ = 0;
};

class Drive {
 public:
  Drive(const DriveModel& model, const DriveHidden& hidden, const DriveRun& run,
        const DriveCommand& command)
      : m_(model),
        h_(hidden),
        run_(run),
        command_(command),
        step_(run.period / inner_steps),
        line_(hidden.delay, step_) {
    const Reference& start = command.reference.front();
    x_ = link_ = sensed_ = played_ = start.position;
    v_ = link_v_ = start.velocity;
    inertia_ = m_.inertia + h_.inertia_more;
    two_ = h_.compliance > 0.0 || h_.backlash > 0.0;
    motor_inertia_ = two_ ? run.motor_share * inertia_ : inertia_;
    link_inertia_ = inertia_ - motor_inertia_;
    // No stiffer than the step can follow.
    const double stiffest = std::min(motor_inertia_, link_inertia_) * 0.16 / (step_ * step_);
    stiffness_ = h_.compliance > 0.0 ? std::min(1.0 / h_.compliance, stiffest) : stiffest;
    spring_damping_ = 0.1 * std::sqrt(stiffness_ * link_inertia_);
    // The log begins with the load carried, not with its fall into the spring.
    const double carried = command.load.front();
    if (two_ && carried != 0.0)
      link_ -= carried / stiffness_ + std::copysign(0.5 * h_.backlash, carried);
  }

  DriveSamples simulate() {
    const auto rows = static_cast<size_t>(run_.seconds / run_.period);
    DriveSamples out;
    for (auto* v : {&out.time, &out.position, &out.effort, &out.reference, &out.load})
      v->reserve(rows);
    for (size_t k = 0; k < rows; ++k) {
      time_ = static_cast<double>(k) * run_.period;
      for (size_t i = 0; i < inner_steps; ++i) {
        const size_t at = k * inner_steps + i;
        const Reference& r = command_.reference[at];
        const double effort = command_.stiffness * (r.position - x_) +
                              command_.damping * (r.velocity - v_) + m_.inertia * r.acceleration +
                              command_.help[at] + command_.load[at];
        if (i == 0) {
          out.time.push_back(time_);
          out.position.push_back(measured());
          out.effort.push_back(effort);
          out.reference.push_back(r.position);
          out.load.push_back(command_.load[at]);
        }
        advance(effort, command_.load[at]);
        time_ += step_;
      }
    }
    return out;
  }

 private:
  // Sliding friction at this speed, without its sign.
  double sliding(double v, double load_now) const {
    const double speed = std::abs(v), soft = std::atan(m_.shape * speed);
    double level = m_.level * (1.0 + h_.friction_scale);
    level *= 1.0 + h_.level_asymmetry * (v > 0.0 ? 1.0 : -1.0);
    if (h_.drift != 0.0) level *= 1.0 + h_.drift * (1.0 - std::exp(-time_ / h_.drift_time));
    if (h_.swing != 0.0) level *= 1.0 + h_.swing * std::sin(2.0 * pi * time_ / h_.swing_time);
    if (h_.memory != 0.0) level *= 1.0 + h_.memory * std::exp(-way_ / (0.1 * m_.amplitude));
    double g = level * soft;
    const double full = soft / (0.5 * pi);
    if (h_.stribeck != 0.0) {
      const double ratio = speed / h_.stribeck_speed;
      g += h_.stribeck * std::exp(-ratio * ratio) * full * 1.6;
    }
    if (h_.concave != 0.0) g += h_.concave * std::sqrt(speed / m_.top_speed) * full;
    if (h_.load_friction != 0.0) g += h_.load_friction * std::abs(load_now) * full;
    return std::max(g, 1.0e-3 * m_.level * soft + 1.0e-12);
  }

  // The bristles' state runs to +-1 over a short way; solved exactly over one step.
  double friction(double v, double load_now) {
    const double g = sliding(v, load_now), speed = std::abs(v), sign = v < 0.0 ? -1.0 : 1.0;
    const double way = speed * step_ / run_.bristle;
    if (run_.bouc_wen) {
      const double grip = sign * z_ > 0.0 ? z_ * z_ : 0.0;
      z_ = std::clamp(z_ + sign * way * (1.0 - grip) / (1.0 + way), -1.0, 1.0);
    } else {
      z_ = sign + (z_ - sign) / (1.0 + way + 0.5 * way * way);
    }
    double viscous = m_.viscous + h_.viscous_more;
    viscous += h_.viscous_asymmetry * sign;
    return g * z_ + viscous * v;
  }

  double position_forces(double x, double load_now) const {
    double f = h_.offset;
    if (h_.output_ripple != 0.0)
      f += h_.output_ripple *
           std::sin(h_.output_order * 2.0 * pi * x / m_.output_turn + h_.output_phase);
    if (h_.input_ripple != 0.0)
      f += h_.input_ripple *
           std::sin(h_.input_order * 2.0 * pi * x / m_.motor_turn + h_.input_phase);
    if (h_.load_ripple != 0.0)
      f +=
          h_.load_ripple * load_now * std::sin(2.0 * pi * x / m_.motor_turn + h_.load_ripple_phase);
    if (h_.bump != 0.0) {
      const double d = (x - h_.bump_at) / h_.bump_width;
      f += h_.bump * std::exp(-d * d);
    }
    if (h_.stop_stiffness != 0.0 && x > h_.stop_at) f += h_.stop_stiffness * (x - h_.stop_at);
    if (h_.hum != 0.0) f += h_.hum * std::sin(h_.hum_rate * time_);
    return f;
  }

  // Friction is steep near rest: its slope is taken implicitly, as its value is not.
  double braked(double inertia) const {
    const double s = m_.shape * v_;
    const double slope = m_.level * m_.shape / (1.0 + s * s) + m_.viscous;
    return inertia + step_ * slope;
  }

  void advance(double effort, double load_now) {
    const double acting = (1.0 + h_.torque_gain) * line_.pass(effort);
    const double resisting = friction(v_, load_now) + position_forces(x_, load_now);
    if (!two_) {
      v_ += step_ * (acting - resisting - load_now) / braked(inertia_);
      turn_memory();
      x_ += step_ * v_;
      link_ = x_;
      return;
    }
    const double stretch = x_ - link_, gap = 0.5 * h_.backlash;
    const double pressed = std::abs(stretch) > gap ? stretch - std::copysign(gap, stretch) : 0.0;
    double spring = stiffness_ * pressed;
    if (pressed != 0.0) spring += spring_damping_ * (v_ - link_v_);
    v_ += step_ * (acting - resisting - spring) / braked(motor_inertia_);
    link_v_ += step_ * (spring - load_now) / link_inertia_;
    turn_memory();
    x_ += step_ * v_;
    link_ += step_ * link_v_;
  }

  void turn_memory() {
    if (v_ * last_v_ < 0.0) way_ = 0.0;
    way_ += std::abs(v_) * step_;
    last_v_ = v_;
  }

  // Called once a logged sample.
  double measured() {
    double y = (1.0 + h_.sensor_scale) * x_;
    if (h_.sensor_lag > 0.0) {
      sensed_ = first_ ? y : y + (sensed_ - y) * std::exp(-run_.period / h_.sensor_lag);
      y = sensed_;
    }
    if (h_.sensor_play > 0.0) {
      played_ =
          first_ ? y : std::clamp(played_, y - 0.5 * h_.sensor_play, y + 0.5 * h_.sensor_play);
      y = played_;
    }
    first_ = false;
    if (h_.sensor_quantum > 0.0) y = h_.sensor_quantum * std::round(y / h_.sensor_quantum);
    return y;
  }

  const DriveModel& m_;
  const DriveHidden& h_;
  const DriveRun& run_;
  const DriveCommand& command_;
  double step_;
  DelayLine line_;
  double inertia_ = 0.0, motor_inertia_ = 0.0, link_inertia_ = 0.0, stiffness_ = 0.0,
         spring_damping_ = 0.0;
  bool two_ = false, first_ = true;
  double time_ = 0.0, x_ = 0.0, v_ = 0.0, link_ = 0.0, link_v_ = 0.0, z_ = 0.0, way_ = 0.0,
         last_v_ = 0.0;
  double sensed_ = 0.0, played_ = 0.0;
};

}  // namespace

DriveCommand draw_command(const DriveModel& model, const DriveRun& run, Draw draw) {
  DriveCommand command;
  const double step = run.period / inner_steps;
  const auto count = static_cast<size_t>(run.seconds / run.period) * inner_steps;
  command.reference = Motion(run.course, model.amplitude, model.top_speed, run.seconds, draw.fork())
                          .table(step, count);
  // Fast enough to follow, slow enough to leave a following error.
  const double bandwidth = 2.0 * pi * draw.uniform(6.0, 11.0);
  command.stiffness = model.inertia * bandwidth * bandwidth;
  command.damping = 2.0 * draw.uniform(0.7, 1.0) * model.inertia * bandwidth;
  const double share = draw.uniform(0.5, 0.9);
  const double rate = 2.0 * pi * draw.uniform(0.15, 0.6), phase = draw.uniform(0.0, 2.0 * pi);
  command.help.resize(count);
  command.load.resize(count);
  for (size_t k = 0; k < count; ++k) {
    const double v = command.reference[k].velocity;
    command.help[k] = share * (model.level * std::atan(model.shape * v) + model.viscous * v);
    if (model.loaded)
      command.load[k] =
          run.load_mean + run.load_swing * std::sin(rate * static_cast<double>(k) * step + phase);
  }
  return command;
}

DriveCommand followed_command(const DriveModel& model, const DriveRun& run,
                              const DriveCommand& controller, const Table& motion) {
  DriveCommand command;
  command.stiffness = controller.stiffness;
  command.damping = controller.damping;
  const std::vector<double>&time = motion.columns[0], &position = motion.columns[1];
  const double period = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  const std::vector<double> velocity = derivative(position, period);
  const std::vector<double> acceleration = derivative(velocity, period);
  const double step = run.period / inner_steps;
  const auto count = static_cast<size_t>(run.seconds / run.period) * inner_steps;
  for (size_t k = 0; k < count; ++k) {
    const double at = static_cast<double>(k) * step / period;
    const size_t i = std::min(static_cast<size_t>(at), position.size() - 2);
    const double u = at - static_cast<double>(i);
    const auto between = [&](const std::vector<double>& x) { return x[i] + u * (x[i + 1] - x[i]); };
    // Hermite's cubic, so that the position is as smooth as its velocity says.
    const double rise = position[i + 1] - position[i];
    const double a = period * velocity[i] - rise, b = rise - period * velocity[i + 1];
    Reference r{between(position) + u * (1.0 - u) * (a * (1.0 - u) + b * u), between(velocity),
                between(acceleration)};
    command.reference.push_back(r);
    command.help.push_back(
        0.7 * (model.level * std::atan(model.shape * r.velocity) + model.viscous * r.velocity));
    command.load.push_back(motion.columns.size() > 2 ? between(motion.columns[2]) : 0.0);
  }
  return command;
}

DriveSamples run_drive(const DriveModel& model, const DriveHidden& hidden, const DriveRun& run,
                       const DriveCommand& command) {
  return Drive(model, hidden, run, command).simulate();
}

}  // namespace sinew::truth

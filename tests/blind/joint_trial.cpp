// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/joint_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <iterator>
#include <numbers>
#include <vector>

#include "tests/reference/random_numbers.h"

namespace sinew::blind {
namespace {

using reference::RandomNumbers;

constexpr double kPi = std::numbers::pi;
constexpr double kDuration = 16.0, kBefore = 1.5;  // s; before: the controller's start, not logged
constexpr double kNoise = 0.01;                    // of the effort's rms, about

/// SI. The scales are of the motion and the effort that it takes.
struct LoneJoint {
  const char* kind;
  bool linear;
  double inertia, coulomb, viscous, weight;  // weight: torque with the arm level
  double reach, speed, effort, encoder_range;
};

constexpr std::array<LoneJoint, 3> kJoints = {{
    {"pendulum", false, 0.06, 0.4, 0.15, 2.12, 1.0, 2.0, 1.6, 2.0 * kPi},
    {"flywheel", false, 0.02, 0.15, 0.06, 0.0, 1.0, 2.0, 0.3, 2.0 * kPi},
    {"slide", true, 90.0, 20.0, 220.0, 0.0, 0.1, 0.15, 60.0, 1.28},
}};

/// What may be hidden, in SI; 0: not.
struct Hidden {
  double viscous = 0.0, coulomb = 0.0, viscous_asymmetry = 0.0, stribeck = 0.0, gain = 0.0;
  double delay = 0.0, ripple = 0.0, drift = 0.0, inertia = 0.0, spring = 0.0, lag = 0.0;
  double scale = 0.0;
};

const char* const kCauses[] = {"viscous_level", "coulomb_level",   "viscous_asymmetry",
                               "stribeck",      "torque_constant", "delay",
                               "ripple",        "friction_drift",  "inertia",
                               "spring",        "sensor_low_pass", "sensor_scale"};

/// Sets one cause; returns its value.
double hide(const std::string& cause, double size, const LoneJoint& j, Hidden& h) {
  const double share = 0.01 * size * j.effort;
  const auto set = [](double& field, double value) { return field = value; };
  if (cause == "viscous_level") return set(h.viscous, 1.6 * share / j.speed);
  if (cause == "coulomb_level") return set(h.coulomb, 1.2 * share);
  if (cause == "viscous_asymmetry") return set(h.viscous_asymmetry, 4.0 * share / j.speed);
  if (cause == "stribeck") return set(h.stribeck, 4.0 * share);
  if (cause == "torque_constant") return set(h.gain, 0.015 * size);
  if (cause == "delay") return set(h.delay, 0.0015 * size);
  if (cause == "ripple") return set(h.ripple, 1.4 * share);
  if (cause == "friction_drift") return set(h.drift, 3.0 * share);
  if (cause == "inertia") return set(h.inertia, 0.025 * size * j.inertia);
  if (cause == "spring") return set(h.spring, 1.6 * share / j.reach);
  if (cause == "sensor_low_pass") return set(h.lag, 0.0015 * size);
  return set(h.scale, 0.008 * size);  // sensor_scale
}

/// The motion asked for: sums of sines, or strokes with rests between.
class Reference {
 public:
  Reference(RandomNumbers& random, const LoneJoint& j, bool strokes) {
    double place = random.uniform(-0.2, 0.2) * j.reach;
    middle_ = place;
    for (int s = 0; s < 5; ++s) {
      const double w = 2.0 * kPi * random.uniform(0.1, 1.5);
      sines_.push_back({w, random.uniform(0.5, 1.0) * std::min(0.5 * j.reach, 0.6 * j.speed / w),
                        random.uniform(0.0, 6.28)});
    }
    if (!strokes) return;
    for (double t = -kBefore; t < kDuration + 1.0;) {
      const double duration = random.uniform(0.6, 2.0);
      const double to = random.uniform(-1.2, 1.2) * j.reach;
      strokes_.push_back({t, duration, place, to - place});
      t += duration + random.uniform(0.05, 0.3);
      place = to;
    }
  }

  /// position, velocity, acceleration
  std::array<double, 3> at(double t) const {
    std::array<double, 3> x{middle_, 0.0, 0.0};
    if (strokes_.empty()) {
      for (const auto& [w, size, phase] : sines_) {
        const double sine = std::sin(w * t + phase);
        x[0] += size * sine;
        x[1] += size * w * std::cos(w * t + phase);
        x[2] -= size * w * w * sine;
      }
      return x;
    }
    std::size_t i = 0;
    while (i + 1 < strokes_.size() && strokes_[i + 1][0] <= t) ++i;
    const auto& [begin, duration, from, way] = strokes_[i];
    const double s = std::min(1.0, (t - begin) / duration), r = 1.0 - s;
    return {from + way * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s),
            way * 30.0 * s * s * r * r / duration,
            way * 60.0 * s * r * (1.0 - 2.0 * s) / (duration * duration)};
  }

 private:
  double middle_;
  std::vector<std::array<double, 3>> sines_;
  std::vector<std::array<double, 4>> strokes_;
};

class Plant {
 public:
  static constexpr double kStep = 1e-5;  // s

  Plant(const LoneJoint& joint, const Hidden& hidden, double wavenumber, double phase)
      : j_(joint), h_(hidden), wavenumber_(wavenumber), phase_(phase) {}

  void start(const std::array<double, 3>& x) {
    q_ = sensed_ = x[0];
    qd_ = x[1];
  }

  /// Follows the reference for one step; the effort is what a log has of it.
  void step(double t, const std::array<double, 3>& wanted) {
    const double w = 2.0 * kPi * 5.0;
    const double error = wanted[0] - q_;
    integral_ += 0.2 * w * w * w * j_.inertia * error * kStep;
    effort_ = j_.inertia * (wanted[2] + 1.8 * w * (wanted[1] - qd_) + w * w * error) + integral_ +
              j_.weight * std::cos(q_) + j_.coulomb * std::tanh(wanted[1] / (0.02 * j_.speed)) +
              j_.viscous * wanted[1];
    const double inertia = j_.inertia + h_.inertia;
    const double turning = 1e-3 * j_.speed;
    const double rest = passive(t);
    // Friction turns within microseconds of motion: taken at the step's end, linearised.
    const double stiffness = (j_.coulomb + h_.coulomb) / turning /
                             std::pow(std::cosh(std::min(20.0, std::abs(qd_) / turning)), 2);
    const double acceleration = (acting() / (1.0 + h_.gain) - rest) / (inertia + stiffness * kStep);
    qd_ += acceleration * kStep;
    q_ += qd_ * kStep;
    sensed_ = h_.lag > 0.0 ? sensed_ + (q_ - sensed_) * kStep / h_.lag : q_;
  }

  double effort() const { return effort_; }
  double sensed() const { return sensed_ * (1.0 + h_.scale); }

 private:
  double acting() {
    if (h_.delay <= 0.0) return effort_;
    line_.push_back(effort_);
    if (static_cast<double>(line_.size()) > h_.delay / kStep) line_.pop_front();
    return line_.front();
  }

  /// What the joint takes beside its inertia.
  double passive(double t) const {
    const double side = std::tanh(qd_ / (1e-3 * j_.speed));
    const double slow = std::exp(-std::pow(qd_ / (0.12 * j_.speed), 2));
    const double warm = 1.0 - std::exp(-std::max(t, 0.0) / (0.3 * kDuration));
    return j_.weight * std::cos(q_) + h_.spring * q_ +
           h_.ripple * std::sin(wavenumber_ * q_ + phase_) + (j_.viscous + h_.viscous) * qd_ +
           0.5 * h_.viscous_asymmetry * std::abs(qd_) +
           side * (j_.coulomb + h_.coulomb + h_.stribeck * slow + h_.drift * warm);
  }

  const LoneJoint& j_;
  const Hidden& h_;
  double wavenumber_, phase_;
  double q_ = 0.0, qd_ = 0.0, sensed_ = 0.0, effort_ = 0.0, integral_ = 0.0;
  std::deque<double> line_;
};

Mechanism mechanism_of(const LoneJoint& j) {
  Mechanism m;
  m.name = j.kind;
  Body body;
  body.name = "l1";
  Joint joint;
  joint.name = "j1";
  joint.type = j.linear ? JointType::prismatic : JointType::revolute;
  joint.axis = j.linear ? Eigen::Vector3d(1, 0, 0) : Eigen::Vector3d(0, -1, 0);
  joint.max_velocity = 10.0;
  joint.damping = j.viscous;
  joint.friction = j.coulomb;
  constexpr double arm = 0.18;
  body.mass = j.linear ? j.inertia : j.weight > 0.0 ? j.weight / (9.81 * arm) : 0.5;
  body.centre_of_mass = Eigen::Vector3d(j.weight > 0.0 ? arm : 0.0, 0, 0);
  const double about_centre =
      j.linear ? 1.0 : j.inertia - (j.weight > 0.0 ? body.mass * arm * arm : 0.0);
  body.inertia = Eigen::Vector3d::Constant(about_centre).asDiagonal();
  m.bodies = {body};
  m.joints = {joint};
  return m;
}

std::string log_of(const LoneJoint& j, const Hidden& hidden, bool strokes, double rate,
                   double encoder_step, double wavenumber, double phase, RandomNumbers& random) {
  const Reference reference(random, j, strokes);
  Plant plant(j, hidden, wavenumber, phase);
  plant.start(reference.at(-kBefore));
  std::string text = j.linear ? "time [s],q_j1 [m],tau_j1 [N]" : "time [s],q_j1 [rad],tau_j1 [N*m]";
  const auto every = std::lround(1.0 / (rate * Plant::kStep));
  const auto before = std::lround(kBefore / Plant::kStep);
  const auto steps = std::lround(kDuration / Plant::kStep);
  double coloured = 0.0;
  const auto draw = [&] { return 1.7 * random.uniform(-1.0, 1.0); };
  for (long k = -before; k < steps; ++k) {
    const double t = Plant::kStep * static_cast<double>(k), sensed = plant.sensed();
    plant.step(t, reference.at(t));
    if (k < 0 || k % every != 0) continue;
    coloured = 0.9 * coloured + 0.44 * draw();
    const double noise = kNoise * j.effort * std::numbers::sqrt2 / 2.0 * (coloured + draw());
    fmt::format_to(std::back_inserter(text), "\n{:.5f},{:.9g},{:.6g}", t,
                   encoder_step * std::round(sensed / encoder_step), plant.effort() + noise);
  }
  return text + "\n";
}

}  // namespace

RobotTrial joint_trial(const truth::TrialRequest& request) {
  RandomNumbers random(request.seed);
  const LoneJoint& j = kJoints[static_cast<std::size_t>(random.index(3))];
  RobotTrial trial;
  trial.nominal = mechanism_of(j);
  const bool strokes = random.chance(0.4);
  const double rate = std::array{250.0, 500.0, 1000.0}[static_cast<std::size_t>(random.index(3))];
  const double encoder_step = j.encoder_range / std::ldexp(1.0, 17 + random.index(4));
  const double wavenumber = 2.0 * kPi * static_cast<double>(4 + random.index(16)) / j.reach / 3.0;
  const double phase = random.uniform(0.0, 6.28);
  const std::string cause = kCauses[static_cast<std::size_t>(random.index(std::size(kCauses)))];
  Hidden hidden;
  trial.seal.family = request.family;
  if (request.family == truth::Family::one)
    trial.seal.hidden = {
        {cause, "joint j1", "", hide(cause, request.size, j, hidden), request.size}};
  for (std::string* log : {&trial.train, &trial.holdout})
    *log = log_of(j, hidden, strokes, rate, encoder_step, wavenumber, phase, random);
  return trial;
}

}  // namespace sinew::blind

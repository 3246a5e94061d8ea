// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/blind/arm_trial.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

#include "tests/reference/newton_euler.h"
#include "tests/reference/random_numbers.h"

namespace sinew::blind {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using reference::RandomNumbers;

constexpr double kStep = 0.004, kDuration = 14.0;  // s
constexpr double kNoise = 0.01;                    // of a channel's rms

struct Motion {
  MatrixXd q, qd, qdd;  // samples x joints
};

/// The axes of an arm of five or six joints: shoulder and elbow upright, a wrist that rolls and
/// pitches.
const std::array<Eigen::Vector3d, 6> kLongAxes = {
    {{0, 0, 1}, {0, -1, 0}, {0, -1, 0}, {1, 0, 0}, {0, -1, 0}, {1, 0, 0}}};

Mechanism draw_arm(RandomNumbers& random, bool is_long) {
  Mechanism arm;
  arm.name = "arm";
  const int joints = is_long ? 5 + random.index(2) : 2 + random.index(2);
  const bool upright = joints == 3 || random.chance(0.5);
  double length = 0.0, mass = random.uniform(1.5, 4.0);
  for (int i = 0; i < joints; ++i) {
    Joint joint;
    joint.name = fmt::format("j{}", i + 1);
    joint.parent = i - 1;
    joint.axis = upright && i > 0 ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 0, 1);
    if (is_long) joint.axis = kLongAxes[static_cast<std::size_t>(i)];
    joint.origin.translation = Eigen::Vector3d(length, 0, i == 0 ? 0.3 : 0.0);
    joint.max_velocity = 20.0;
    length = random.uniform(0.2, 0.4);
    const double thick = 0.05;
    Body body;
    body.name = fmt::format("l{}", i + 1);
    body.mass = mass;
    body.centre_of_mass = Eigen::Vector3d(random.uniform(0.3, 0.6) * length, 0, 0);
    if (is_long) body.centre_of_mass.z() = random.uniform(0.05, 0.2) * length;
    const double across = mass * (length * length + thick * thick) / 12.0;
    body.inertia = Eigen::Vector3d(mass * thick * thick / 6.0, across, across).asDiagonal();
    joint.damping = random.uniform(0.05, 0.2) * mass;
    joint.friction = random.uniform(0.1, 0.3) * mass;
    arm.bodies.push_back(body);
    arm.joints.push_back(joint);
    mass *= random.uniform(0.4, 0.7);
  }
  return arm;
}

/// Sums of sines, or strokes with rests between.
Motion draw_motion(RandomNumbers& random, Index joints, bool strokes) {
  const auto samples = static_cast<Index>(kDuration / kStep);
  const MatrixXd none = MatrixXd::Zero(samples, joints);
  Motion m{none, none, none};
  for (Index j = 0; j < joints; ++j) {
    double place = random.uniform(-0.4, 0.4);
    if (!strokes) {
      m.q.col(j).setConstant(place);
      for (int s = 0; s < 5; ++s) {
        const double w = 2.0 * std::numbers::pi * random.uniform(0.1, 1.5);
        const double size = random.uniform(0.5, 1.0) * std::min(0.5, 1.2 / w);
        const double phase = random.uniform(0.0, 6.28);
        for (Index k = 0; k < samples; ++k) {
          const double angle = w * kStep * static_cast<double>(k) + phase;
          m.q(k, j) += size * std::sin(angle);
          m.qd(k, j) += size * w * std::cos(angle);
          m.qdd(k, j) -= size * w * w * std::sin(angle);
        }
      }
      continue;
    }
    for (Index k = 0; k < samples;) {
      const double duration = random.uniform(0.6, 2.0), to = random.uniform(-1.2, 1.2);
      const double way = to - place;
      const auto end = std::min(samples, k + static_cast<Index>(duration / kStep));
      for (Index first = k; k < end; ++k) {
        const double s = kStep * static_cast<double>(k - first) / duration, r = 1.0 - s;
        m.q(k, j) = place + way * s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
        m.qd(k, j) = way * 30.0 * s * s * r * r / duration;
        m.qdd(k, j) = way * 60.0 * s * r * (1.0 - 2.0 * s) / (duration * duration);
      }
      place = to;
      const Index rest = k + static_cast<Index>(random.uniform(0.05, 0.4) / kStep);
      for (; k < std::min(samples, rest); ++k) m.q(k, j) = place;
    }
  }
  return m;
}

/// Direction of friction: turns over some speed, or stays at rest what it was.
VectorXd direction(const VectorXd& velocity, double speed) {
  VectorXd side(velocity.size());
  double last = 0.0;
  for (Index k = 0; k < side.size(); ++k) {
    if (velocity(k) != 0.0) last = velocity(k) > 0.0 ? 1.0 : -1.0;
    side(k) = speed > 0.0 ? std::tanh(velocity(k) / speed) : last;
  }
  return side;
}

MatrixXd torques(const Mechanism& arm, const Motion& m) {
  const reference::NewtonEuler<double> newton_euler(arm);
  MatrixXd tau(m.q.rows(), m.q.cols());
  for (Index k = 0; k < tau.rows(); ++k)
    tau.row(k) = newton_euler
                     .inverse_dynamics(m.q.row(k).transpose(), m.qd.row(k).transpose(),
                                       m.qdd.row(k).transpose())
                     .transpose();
  return tau;
}

double rms(const VectorXd& x) {
  return std::sqrt((x.array() - x.mean()).square().mean());
}

const char* const kCauses[] = {
    "payload",         "viscous_level", "coulomb_level",  "stribeck", "load_friction",
    "torque_constant", "offset",        "friction_drift", "spring",   "inertia"};

/// What a cause of unit size adds to one joint's torque.
VectorXd added(const std::string& cause, const Motion& m, Index joint, const VectorXd& side,
               const VectorXd& links, const VectorXd& all) {
  const VectorXd v = m.qd.col(joint);
  const VectorXd time = VectorXd::LinSpaced(v.size(), 0.0, kDuration);
  if (cause == "viscous_level") return v;
  if (cause == "coulomb_level") return side;
  if (cause == "stribeck")
    return side.array() * (-(v.array() / (0.2 * v.cwiseAbs().maxCoeff())).square()).exp();
  if (cause == "load_friction") return links.cwiseAbs().cwiseProduct(side);
  if (cause == "torque_constant") return all;
  if (cause == "friction_drift")
    return side.array() * (1.0 - (-time.array() / (0.3 * kDuration)).exp());
  if (cause == "spring") return m.q.col(joint);
  if (cause == "inertia") return m.qdd.col(joint);
  return VectorXd::Ones(v.size());  // offset
}

struct Hidden {
  std::string cause;  // empty: nothing
  Index joint = 0;
  double size = 0.0, value = 0.0;  // value: 0 until the training log has set it
  Index late = 0;                  // samples that all torques are measured late
};

struct Sensors {
  double turning_speed, encoder_step;
};

MatrixXd measured(const Mechanism& arm, const Motion& m, const Sensors& sensors, Hidden& hidden,
                  RandomNumbers& random) {
  const MatrixXd links = torques(arm, m);
  MatrixXd tau = links, side = links;
  for (Index j = 0; j < tau.cols(); ++j) {
    const Joint& joint = arm.joints[static_cast<std::size_t>(j)];
    side.col(j) = direction(m.qd.col(j), sensors.turning_speed);
    tau.col(j) += joint.damping * m.qd.col(j) + joint.friction * side.col(j);
  }
  VectorXd noise(tau.cols());
  for (Index j = 0; j < tau.cols(); ++j) noise(j) = kNoise * rms(tau.col(j));
  const Index at = hidden.joint;
  if (hidden.cause == "payload") {
    Mechanism loaded = arm;
    Body& body = loaded.bodies.back();
    const double more = 0.1 * body.mass;
    const Eigen::Vector3d tip(2.0 * body.centre_of_mass.x(), 0, 0);
    const Eigen::Vector3d centre =
        (body.mass * body.centre_of_mass + more * tip) / (body.mass + more);
    const auto about = [&](double mass, const Eigen::Vector3d& from) -> Eigen::Matrix3d {
      const Eigen::Vector3d c = from - centre;
      return mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    };
    body.inertia += about(body.mass, body.centre_of_mass) + about(more, tip);
    body.mass += more;
    body.centre_of_mass = centre;
    tau += torques(loaded, m) - links;
    hidden.value = more;
  } else if (!hidden.cause.empty() && hidden.late == 0) {
    const VectorXd more = added(hidden.cause, m, at, side.col(at), links.col(at), tau.col(at));
    const double unit = hidden.cause == "offset" ? 1.0 : rms(more);
    if (hidden.value == 0.0) hidden.value = hidden.size * noise(at) / unit;
    tau.col(at) += hidden.value * more;
  }
  if (hidden.late > 0) {
    const Index rest = tau.rows() - hidden.late;
    tau.bottomRows(rest) = MatrixXd(tau.topRows(rest));
  }
  for (Index j = 0; j < tau.cols(); ++j) {
    double coloured = 0.0;
    const auto draw = [&] { return 1.7 * random.uniform(-1.0, 1.0); };
    for (Index k = 0; k < tau.rows(); ++k) {
      coloured = 0.9 * coloured + 0.44 * draw();
      tau(k, j) += noise(j) * std::numbers::sqrt2 / 2.0 * (coloured + draw());
    }
  }
  return tau;
}

std::string csv(const Mechanism& arm, const Motion& m, const MatrixXd& tau, double encoder_step) {
  std::string text = "time [s]";
  for (const Joint& j : arm.joints) text += fmt::format(",q_{} [rad]", j.name);
  for (const Joint& j : arm.joints) text += fmt::format(",tau_{} [N*m]", j.name);
  for (Index k = 0; k < tau.rows(); ++k) {
    fmt::format_to(std::back_inserter(text), "\n{:.4f}", kStep * static_cast<double>(k));
    for (Index j = 0; j < tau.cols(); ++j)
      fmt::format_to(std::back_inserter(text), ",{:.9g}",
                     encoder_step * std::round(m.q(k, j) / encoder_step));
    for (Index j = 0; j < tau.cols(); ++j)
      fmt::format_to(std::back_inserter(text), ",{:.6g}", tau(k, j));
  }
  return text + "\n";
}

}  // namespace

RobotTrial arm_trial(const truth::TrialRequest& request) {
  RandomNumbers random(request.seed);
  RobotTrial trial;
  const bool is_long = request.plant == "long_arm";
  trial.nominal = draw_arm(random, is_long);
  const auto joints = static_cast<Index>(trial.nominal.joints.size());
  const bool strokes = random.chance(0.5), held = random.chance(0.3);
  const double turning_speed = held ? 0.0 : std::pow(10.0, random.uniform(-3.0, -1.7));
  const double counts = std::ldexp(1.0, 18 + random.index(4));
  const Sensors sensors{turning_speed, 2.0 * std::numbers::pi / counts};
  Hidden hidden;
  const std::string drawn = kCauses[static_cast<std::size_t>(random.index(std::size(kCauses)))];
  hidden.joint = random.index(static_cast<int>(joints));
  hidden.size = request.size;
  if (request.family == truth::Family::one) hidden.cause = drawn;
  if (is_long && !hidden.cause.empty() && random.chance(0.15)) {
    hidden.cause = "delay";
    hidden.late = 1;
    hidden.value = -kStep * static_cast<double>(hidden.late);
  }
  for (std::string* log : {&trial.train, &trial.holdout}) {
    const Motion motion = draw_motion(random, joints, strokes);
    const MatrixXd tau = measured(trial.nominal, motion, sensors, hidden, random);
    *log = csv(trial.nominal, motion, tau, sensors.encoder_step);
  }
  trial.seal.family = request.family;
  if (hidden.cause.empty()) return trial;
  const std::string place = hidden.cause == "payload" ? "link " + trial.nominal.bodies.back().name
                            : hidden.late > 0         ? "all joints"
                                                      : fmt::format("joint j{}", hidden.joint + 1);
  trial.seal.hidden = {{hidden.cause, place, "", hidden.value, hidden.size}};
  return trial;
}

}  // namespace sinew::blind

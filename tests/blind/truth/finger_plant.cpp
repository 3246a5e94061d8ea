// SPDX-License-Identifier: GPL-3.0-or-later
// A finger of four joints, pulled by eight elastic tendons, each with its motor and, at the motor,
// a force sensor.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/blind/truth/finger_body.h"
#include "tests/blind/truth/plant.h"
#include "tests/blind/truth/signals.h"

namespace sinew::truth {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr size_t motors = 8;
constexpr int inner_steps = 5;
using Matrix84 = Eigen::Matrix<double, 8, 4>;
using Vector8 = Eigen::Matrix<double, 8, 1>;

struct FingerModel {
  double inertia = 2.05e-3, shape = 10.0, level = 0.5586, viscous = 0.0356;  // motors, output side
  double motor_turn = 2.0 * pi / 100.0, motor_radius = 0.005;
  double stiffness = 1.2e4, pretension = 20.0;  // tendons: N/m, N
  double damping = 1.0e-4;                      // joints
  bool gravity = true;
  Matrix84 pulleys;  // dh/dq, m
};

struct FingerHidden {
  double payload = 0.0, gravity = 0.0, joint_damping = 0.0, pulley = 0.0;
  double guiding = 0.0, level = 0.0, viscous = 0.0, input_ripple = 0.0, torque_gain = 0.0;
  double force_scale = 0.0, force_offset = 0.0;  // what the sensor shows of the tendon
  double elbow = 0.0, rattle = 0.0;              // outside: a stiff joint, tension that wanders
};

struct FingerCause {
  Cause cause;
  double FingerHidden::*field;
};

Matrix84 pulley_matrix() {
  Matrix84 p;
  const double a = 0.0065, b = 0.0055, c = 0.0045;
  p << a, a, 0, 0,   //
      a, -a, 0, 0,   //
      -a, a, 0, 0,   //
      -a, -a, 0, 0,  //
      0, 0, b, 0,    //
      0, 0, -b, 0,   //
      0, 0, b, -c,   //
      0, 0, -b, c;
  return p;
}

// State of the whole and one step of it.
class FingerRun {
 public:
  FingerRun(const FingerModel& model, const FingerHidden& hidden, size_t motor, long joint,
            double ripple_phase)
      : m_(model), h_(hidden), motor_(motor), joint_(joint), ripple_phase_(ripple_phase) {
    body_.gravity = model.gravity ? 9.81 : 9.81 * hidden.gravity;
    body_.payload = hidden.payload;
    true_pulleys_ = model.pulleys;
    true_pulleys_.col(joint) *= 1.0 + hidden.pulley;
  }

  Vector4 q = Vector4::Zero(), qd = Vector4::Zero();
  Vector8 theta = Vector8::Zero(), omega = Vector8::Zero();

  /// At the motors' end of the tendons.
  Vector8 pull() const {
    const Vector8 stretch = m_.motor_radius * theta + true_pulleys_ * q;
    return (m_.stiffness * stretch.array() + m_.pretension).max(0.0);
  }

  void start(const Vector4& at) {
    q = at;
    theta = -true_pulleys_ * at / m_.motor_radius;
  }

  void advance(const Vector8& effort, double time, double step) {
    const Vector8 pull_motor = pull();
    Vector8 pull_finger = pull_motor;
    for (size_t i = 0; i < motors; ++i) {
      const auto k = static_cast<long>(i);
      if (h_.rattle != 0.0 && i == motor_)
        pull_finger(k) += h_.rattle * std::sin(23.0 * time + 3.0 * std::sin(1.3 * time));
      if (h_.guiding != 0.0 && i == motor_) {
        const double bend = 0.8 + std::abs(q(1)) + std::abs(q(2));
        pull_finger(k) *= std::exp(-h_.guiding * bend * std::tanh(omega(k) / 0.02));
      }
    }
    move_motors(effort, pull_motor, step);
    move_joints(pull_finger, step);
  }

 private:
  void move_motors(const Vector8& effort, const Vector8& pull, double step) {
    for (size_t i = 0; i < motors; ++i) {
      const auto k = static_cast<long>(i);
      const bool here = i == motor_;
      const double level = m_.level * (1.0 + (here ? h_.level : 0.0));
      const double viscous = m_.viscous + (here ? h_.viscous : 0.0);
      const double sliding = std::max(level * std::atan(m_.shape * std::abs(omega(k))), 1.0e-9);
      const double sign = omega(k) < 0.0 ? -1.0 : 1.0;
      const double way = std::abs(omega(k)) * step / 5.0e-6;
      bristle_(k) = sign + (bristle_(k) - sign) / (1.0 + way + 0.5 * way * way);
      double resisting = sliding * bristle_(k) + viscous * omega(k);
      if (here && h_.input_ripple != 0.0)
        resisting +=
            h_.input_ripple * std::sin(2.0 * pi * theta(k) / m_.motor_turn + ripple_phase_);
      const double acting = effort(k) * (1.0 + (here ? h_.torque_gain : 0.0));
      // Friction is steep near rest: its slope is taken implicitly.
      const double s = m_.shape * omega(k), slope = level * m_.shape / (1.0 + s * s) + viscous;
      omega(k) +=
          step * (acting - resisting - m_.motor_radius * pull(k)) / (m_.inertia + step * slope);
      theta(k) += step * omega(k);
    }
  }

  // Damping and the tendons' stiffness are taken at the end of the step: the distal links are
  // light.
  void move_joints(const Vector8& pull, double step) {
    Vector4 torque = -true_pulleys_.transpose() * pull;
    Vector4 damping = Vector4::Constant(m_.damping);
    damping(joint_) += h_.joint_damping;
    if (h_.elbow != 0.0) torque(joint_) -= h_.elbow * std::pow(q(joint_), 3);
    const Matrix4 M = body_.mass_matrix(q);
    const Vector4 zero = Vector4::Zero();
    const Vector4 rest = body_.torque(q, zero, zero);
    const Vector4 moving = body_.torque(q, qd, zero) - rest;
    Matrix4 left = M;
    left.diagonal() += step * damping;
    const Vector4 right = torque - rest - moving - damping.cwiseProduct(qd);
    qd += left.llt().solve(step * right);
    q += step * qd;
  }

  const FingerModel& m_;
  const FingerHidden& h_;
  size_t motor_;
  long joint_;
  double ripple_phase_;
  FingerBody body_;
  Matrix84 true_pulleys_;
  Vector8 bristle_ = Vector8::Zero();
};

class FingerPlant : public Plant {
 public:
  explicit FingerPlant(Draw draw) {
    model_.pulleys = pulley_matrix();
    model_.gravity = draw.chance(0.7);
    sigma_ = draw.uniform(0.006, 0.02);
    motor_ = static_cast<size_t>(draw.below(motors));
    joint_ = draw.below(4);
    phase_ = draw.uniform(0.0, 2.0 * pi);
    for (auto& s : streams_) s = draw.bits();
    const std::string m = fmt::format("motor {}", motor_ + 1),
                      t = fmt::format("tendon {}", motor_ + 1);
    const std::string j = fmt::format("joint q2{}", joint_);
    using H = FingerHidden;
    causes_ = {
        {{"payload", "finger", "kg", 0.05, 1.5, 0.0, false, false}, &H::payload},
        {{"joint_damping", j, "N*m*s/rad", 2.0e-3, 0.2, 0.0, false, false}, &H::joint_damping},
        {{"pulley_radius", j, "1", 0.02, 0.3, -0.3, false, false}, &H::pulley},
        {{"guiding_friction", t, "1", 0.03, 0.6, 0.0, false, false}, &H::guiding},
        {{"coulomb_level", m, "1", 0.05, 2.0, -0.5, false, false}, &H::level},
        {{"viscous_level", m, "N*m*s/rad", 0.01, 1.0, -0.025, false, false}, &H::viscous},
        {{"input_ripple", m, "N*m", 0.03, 1.0, 0.0, false, false}, &H::input_ripple},
        {{"torque_constant", m, "1", 0.05, 0.6, -0.4, false, false}, &H::torque_gain},
        {{"force_scale", t, "1", 0.01, 0.28, -0.28, false, false}, &H::force_scale},
        {{"force_offset", t, "N", 0.1, 20.0, -10.0, false, false}, &H::force_offset},
        {{"stiff_joint", j, "N*m/rad^3", 0.05, 1.0, 0.0, true, false}, &H::elbow},
        {{"wandering_tension", t, "N", 2.0, 18.0, 0.0, true, false}, &H::rattle},
    };
    if (!model_.gravity)
      causes_.push_back({{"gravity", "finger", "1", 1.0, 1.0, 0.0, false, true}, &H::gravity});
    for (const FingerCause& c : causes_) listed_.push_back(c.cause);
  }

  std::string kind() const override { return "finger"; }
  std::string nominal() const override {
    return fmt::format(
        "{{\"inertia\": {:.17g}, \"friction_shape\": {:.17g}, \"friction_level\": {:.17g}, "
        "\"viscous\": {:.17g}, \"motor_turn\": {:.17g}, \"motor_radius\": {:.17g}, "
        "\"tendon_stiffness\": {:.17g}, \"pretension\": {:.17g}, \"joint_damping\": {:.17g}, "
        "\"gravity\": {}}}",
        model_.inertia, model_.shape, model_.level, model_.viscous, model_.motor_turn,
        model_.motor_radius, model_.stiffness, model_.pretension, model_.damping, model_.gravity);
  }
  const std::vector<Cause>& causes() const override { return listed_; }
  void scale_noise(double factor) override { sigma_ *= factor; }

  Table simulate(const std::vector<Dose>& doses, int log) const override {
    FingerHidden h;
    for (const Dose& d : doses) h.*causes_[static_cast<size_t>(d.cause)].field = d.value;
    const size_t rows = 8000;
    const double period = 1.0e-3, step = period / inner_steps;
    Draw draw(streams_[static_cast<size_t>(log) % std::size(streams_)]);
    std::vector<std::vector<Reference>> course;
    const double reach[4] = {0.25, 0.55, 0.55, 0.5}, middle[4] = {0.0, 0.6, 0.6, 0.5};
    for (const double r : reach)
      course.push_back(
          Motion(Course::mixed, r, 4.5 * r, 8.0, draw.fork()).table(step, rows * inner_steps));
    FingerRun run(model_, h, motor_, joint_, phase_ + 2.4 * log);
    const auto wanted = [&](size_t k, Vector4& q, Vector4& qd) {
      for (size_t j = 0; j < 4; ++j) {
        q(static_cast<long>(j)) = middle[j] + course[j][k].position;
        qd(static_cast<long>(j)) = course[j][k].velocity;
      }
    };
    Vector4 q, qd;
    wanted(0, q, qd);
    run.start(q);
    Table t = empty_table(rows);
    const double bandwidth = 2.0 * pi * 8.0, kp = model_.inertia * bandwidth * bandwidth * 3.0,
                 kd = 2.0 * model_.inertia * bandwidth * 2.0;
    for (size_t k = 0; k < rows * inner_steps; ++k) {
      wanted(k, q, qd);
      const Vector8 theta_d = -model_.pulleys * q / model_.motor_radius;
      const Vector8 omega_d = -model_.pulleys * qd / model_.motor_radius;
      Vector8 effort;
      for (long i = 0; i < 8; ++i)
        effort(i) = kp * (theta_d(i) - run.theta(i)) + kd * (omega_d(i) - run.omega(i)) +
                    model_.motor_radius * model_.pretension +
                    0.8 * model_.level * std::atan(model_.shape * omega_d(i)) +
                    model_.viscous * omega_d(i);
      if (k % inner_steps == 0) log_row(t, k / inner_steps, period, run, effort, h);
      run.advance(effort, static_cast<double>(k) * step, step);
    }
    return t;
  }

  // Motors: what their torque leaves over against their tendon's force. Joints: what the tendons'
  // forces leave over against the links' motion.
  std::vector<std::vector<double>> left_over(const Table& log,
                                             const std::vector<Dose>&) const override {
    const double period = log.columns[0][1] - log.columns[0][0];
    const size_t rows = log.columns[0].size();
    std::vector<std::vector<double>> qs, vs, as, left(12, std::vector<double>(rows));
    for (size_t j = 0; j < 4; ++j) {
      qs.push_back(log.columns[1 + j]);
      vs.push_back(derivative(qs.back(), period));
      as.push_back(derivative(vs.back(), period));
    }
    const auto pull = [&](size_t i) -> const std::vector<double>& {
      return log.columns[5 + 2 * motors + i];
    };
    for (size_t i = 0; i < motors; ++i) {
      const std::vector<double> v = derivative(log.columns[5 + i], period),
                                a = derivative(v, period);
      for (size_t k = 0; k < rows; ++k)
        left[i][k] = (log.columns[5 + motors + i][k] - model_.inertia * a[k] -
                      model_.level * std::atan(model_.shape * v[k]) - model_.viscous * v[k] -
                      model_.motor_radius * pull(i)[k]) /
                     sigma_;
    }
    FingerBody body;
    body.gravity = model_.gravity ? 9.81 : 0.0;
    for (size_t k = 0; k < rows; ++k) {
      Vector4 q, qd, qdd;
      for (long j = 0; j < 4; ++j) {
        q(j) = qs[static_cast<size_t>(j)][k];
        qd(j) = vs[static_cast<size_t>(j)][k];
        qdd(j) = as[static_cast<size_t>(j)][k];
      }
      const Vector4 needed = body.torque(q, qd, qdd);
      for (size_t j = 0; j < 4; ++j) {
        const auto c = static_cast<long>(j);
        double sum = needed(c) + model_.damping * vs[j][k];
        for (size_t i = 0; i < motors; ++i)
          sum += model_.pulleys(static_cast<long>(i), c) * pull(i)[k];
        left[8 + j][k] = sum / (force_noise() * model_.pulleys.col(c).norm());
      }
    }
    for (auto& x : left) x = inner(smoothed(x, 6));
    return left;
  }

  void measure(Table& log, int number) const override {
    Draw draw(streams_[static_cast<size_t>(number) % std::size(streams_)] ^ 0x5bd1e995u);
    for (size_t j = 0; j < 4; ++j)
      for (double& x : log.columns[1 + j]) x += 1.0e-5 * draw.normal();
    const double count = 2.0 * pi / 409600.0;
    for (size_t i = 0; i < motors; ++i) {
      for (double& x : log.columns[5 + i]) x = count * std::round(x / count);
      Noise noise(draw.fork()), of_force(draw.fork());
      for (double& x : log.columns[5 + motors + i]) x += sigma_ * noise.next();
      for (double& x : log.columns[5 + 2 * motors + i]) x += force_noise() * of_force.next();
    }
  }

 private:
  double force_noise() const { return 0.2 * sigma_ / model_.motor_radius; }  // N

  static Table empty_table(size_t rows) {
    Table t;
    t.header = {"time [s]", "q20 [rad]", "q21 [rad]", "q22 [rad]", "q23 [rad]"};
    for (size_t i = 1; i <= motors; ++i) t.header.push_back(fmt::format("theta_{} [rad]", i));
    for (size_t i = 1; i <= motors; ++i) t.header.push_back(fmt::format("tau_{} [N·m]", i));
    for (size_t i = 1; i <= motors; ++i) t.header.push_back(fmt::format("force_{} [N]", i));
    t.columns.assign(t.header.size(), std::vector<double>(rows));
    return t;
  }
  void log_row(Table& t, size_t row, double period, const FingerRun& run, const Vector8& effort,
               const FingerHidden& h) const {
    t.columns[0][row] = static_cast<double>(row) * period;
    for (size_t j = 0; j < 4; ++j) t.columns[1 + j][row] = run.q(static_cast<long>(j));
    const Vector8 pull = run.pull();
    for (size_t i = 0; i < motors; ++i) {
      t.columns[5 + 2 * motors + i][row] = pull(static_cast<long>(i));
      t.columns[5 + i][row] = run.theta(static_cast<long>(i));
      t.columns[5 + motors + i][row] = effort(static_cast<long>(i));
    }
    double& shown = t.columns[5 + 2 * motors + motor_][row];
    shown += h.force_scale * shown + h.force_offset;
  }
  // The first quarter second settles.
  static std::vector<double> inner(const std::vector<double>& x) {
    std::vector<double> y;
    for (size_t k = 250; k + 20 < x.size(); k += 3) y.push_back(x[k]);
    return y;
  }

  FingerModel model_;
  double sigma_ = 0.02, phase_ = 0.0;
  size_t motor_ = 0;
  long joint_ = 0;
  std::uint64_t streams_[4] = {};
  std::vector<FingerCause> causes_;
  std::vector<Cause> listed_;
};

}  // namespace

std::unique_ptr<Plant> draw_finger(Draw draw) {
  return std::make_unique<FingerPlant>(draw);
}

}  // namespace sinew::truth

// SPDX-License-Identifier: GPL-3.0-or-later
// The wrist moves, the fingers are held and the tendons kept at their force: the motors follow the
// tendons. Double inverted parallelogram, worked out point by point.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "tests/blind/truth/plant.h"
#include "tests/blind/truth/signals.h"

namespace sinew::truth {
namespace {

using Eigen::Vector3d;
constexpr double pi = 3.14159265358979323846;
constexpr size_t tendons = 8;

struct WristModel {
  double a = 0.050, b = 0.042, c = 0.036, motor_radius = 0.005;
};

// Where tendons 1 to 8 leave the forearm and enter the palm.
Vector3d forearm_point(size_t i) {
  static constexpr std::array<double, tendons> y = {0.007, 0.008, 0.010, 0.011,
                                                    0.013, 0.015, 0.016, 0.018};
  return {0.004, y[i], 0.008};
}
Vector3d palm_point(size_t i) {
  static constexpr std::array<double, tendons> y = {-0.011, -0.010, -0.008, -0.006,
                                                    -0.005, -0.003, -0.002, 0.0};
  return {-0.004, y[i], 0.010};
}

struct Pose {
  Eigen::Matrix3d rotation;
  Vector3d origin;
};

Pose palm_pose(const WristModel& m, double q71, double q73) {
  const double r2 = m.a * m.a + m.b * m.b + m.c * m.c, r = std::sqrt(r2);
  const Vector3d y(0.0, 1.0, 0.0), e(std::cos(q71), 0.0, std::sin(q71));
  const double tb = 0.5 * pi - q73;
  // Bars B0-B and C0-C cross: the angle of the second follows from the coupler's length.
  const double tc =
      std::atan2((r2 + m.b * m.b) * std::sin(tb) - 2.0 * r * m.b, (r2 - m.b * m.b) * std::cos(tb));
  const Vector3d B = r * (std::cos(tb) * e + std::sin(tb) * y);
  const Vector3d C = m.b * y + r * (std::cos(tc) * e + std::sin(tc) * y);
  const Vector3d M = 0.5 * (B + C);
  const Vector3d x_axis = (C - M).normalized(), z_axis(-std::sin(q71), 0.0, std::cos(q71));
  const Vector3d y_axis = z_axis.cross(x_axis);
  // A lies |AM| from M across BC and |AA0| from A0; of the two points the crossed one.
  const Vector3d A0(0.0, 0.5 * m.b, m.c), d = A0 - M;
  const double py = y_axis.dot(d), pz = z_axis.dot(d);
  const double am = m.c, aa0 = std::sqrt(m.a * m.a + m.c * m.c);
  const double k = (d.squaredNorm() + am * am - aa0 * aa0) / (2.0 * am);
  const double ta = std::atan2(pz, py) + std::acos(k / std::hypot(py, pz));
  const Vector3d A = M + am * (std::cos(ta) * y_axis + std::sin(ta) * z_axis);
  Pose pose;
  const Vector3d v = (B - C).normalized(), w = (M - A).normalized();
  pose.rotation.col(0) = v.cross(w);
  pose.rotation.col(1) = v;
  pose.rotation.col(2) = w;
  pose.origin = 0.5 * (A + M);
  return pose;
}

struct WristHidden {
  double left_uncompensated = 0.0, zero71 = 0.0, zero73 = 0.0, contact = 0.0, scale = 0.0,
         coarse = 0.0;
  double drag = 0.0, sag = 0.0, loose = 0.0;
};

struct WristCause {
  Cause cause;
  double WristHidden::*field;
};

class WristPlant : public Plant {
 public:
  explicit WristPlant(Draw draw) {
    for (auto& s : streams_) s = draw.bits();
    sigma_ = draw.uniform(4.0e-3, 1.5e-2);
    zero71_ = std::atan2(model_.c, model_.a);
    zero73_ = std::acos(model_.b /
                        std::sqrt(model_.a * model_.a + model_.b * model_.b + model_.c * model_.c));
    using H = WristHidden;
    causes_ = {
        {{"wrist_coupling", "wrist", "1", 0.02, 1.0, 0.0, false, false}, &H::left_uncompensated},
        {{"wrist_zero", "q71", "rad", 0.01, 0.3, -0.3, false, false}, &H::zero71},
        {{"wrist_zero", "q73", "rad", 0.01, 0.3, -0.3, false, false}, &H::zero73},
        {{"contact_shift", "wrist", "m", 2.0e-4, 5.0e-3, 0.0, false, false}, &H::contact},
        {{"sensor_scale", "q71", "1", 0.02, 0.4, -0.4, false, false}, &H::scale},
        {{"sensor_quantisation", "q73", "rad", 2.0e-3, 0.1, 0.0, false, false}, &H::coarse},
        {{"drag", "wrist", "rad", 0.01, 1.0, 0.0, true, false}, &H::drag},
        {{"sag", "wrist", "rad", 0.01, 1.0, 0.0, true, false}, &H::sag},
        {{"loose", "motor 5", "rad", 0.02, 1.0, 0.0, true, false}, &H::loose},
    };
    for (const WristCause& c : causes_) listed_.push_back(c.cause);
  }

  std::string kind() const override { return "wrist"; }
  std::string nominal() const override {
    return fmt::format(
        "{{\"a\": {:.17g}, \"b\": {:.17g}, \"c\": {:.17g}, \"motor_radius\": {:.17g}, "
        "\"tendons\": {}}}",
        model_.a, model_.b, model_.c, model_.motor_radius, tendons);
  }
  const std::vector<Cause>& causes() const override { return listed_; }

  // q71 and q73 in the log are the mechanism's own angles, reference pose at (35.75, 55.72)
  // degrees.
  Table simulate(const std::vector<Dose>& doses, int log) const override {
    WristHidden h;
    for (const Dose& d : doses) h.*causes_[static_cast<size_t>(d.cause)].field = d.value;
    const size_t rows = 12000;
    const double period = 1.0 / 600.0;
    Draw draw(streams_[static_cast<size_t>(log) % std::size(streams_)]);
    const auto flexion = Motion(Course::mixed, 0.24, 0.7, 20.0, draw.fork()).table(period, rows);
    const auto abduction = Motion(Course::mixed, 0.3, 0.9, 20.0, draw.fork()).table(period, rows);
    Table t;
    t.header = {"time [s]", "q71 [rad]", "q73 [rad]"};
    for (size_t i = 1; i <= tendons; ++i) t.header.push_back(fmt::format("theta_{} [rad]", i));
    t.columns.assign(t.header.size(), std::vector<double>(rows));
    std::array<double, tendons> start{}, lag{};
    double played = 0.0;
    std::array<Vector3d, tendons> first_direction;
    for (size_t k = 0; k < rows; ++k) {
      const double q71 = zero71_ + flexion[k].position, q73 = zero73_ + abduction[k].position;
      const Pose pose = palm_pose(model_, q71 + h.zero71, q73 + h.zero73);
      double seen71 = zero71_ + (q71 - zero71_) * (1.0 + h.scale), seen73 = q73;
      if (h.coarse > 0.0) seen73 = h.coarse * std::round(seen73 / h.coarse);
      t.columns[0][k] = static_cast<double>(k) * period;
      t.columns[1][k] = seen71;
      t.columns[2][k] = seen73;
      for (size_t i = 0; i < tendons; ++i) {
        const Vector3d span = pose.rotation * palm_point(i) + pose.origin - forearm_point(i);
        const Vector3d direction = span.normalized();
        if (k == 0) first_direction[i] = direction;
        // The tendon winds on and off a small pulley at either end as its direction turns.
        const double turned = std::acos(std::min(1.0, direction.dot(first_direction[i])));
        double length = span.norm() + h.contact * turned;
        if (k == 0) start[i] = length;
        length = (length - start[i]) * (1.0 - h.left_uncompensated);
        double theta = -length / model_.motor_radius;
        lag[i] += 0.01 * (std::tanh(40.0 * abduction[k].velocity) - lag[i]);
        theta +=
            h.drag * lag[i] + h.sag * std::sin(6.0 * abduction[k].position) * flexion[k].velocity;
        if (i == 4 && h.loose > 0.0) {
          played = std::clamp(played, theta - 0.5 * h.loose, theta + 0.5 * h.loose);
          theta = played;
        }
        t.columns[3 + i][k] = theta;
      }
    }
    return t;
  }

  std::vector<std::vector<double>> left_over(const Table& log,
                                             const std::vector<Dose>&) const override {
    std::vector<std::vector<double>> left(tendons);
    for (size_t k = 0; k < log.columns[0].size(); k += 6) {
      const Pose pose = palm_pose(model_, log.columns[1][k], log.columns[2][k]);
      for (size_t i = 0; i < tendons; ++i) {
        const double length =
            (pose.rotation * palm_point(i) + pose.origin - forearm_point(i)).norm();
        left[i].push_back((log.columns[3 + i][k] + length / model_.motor_radius) / sigma_);
      }
    }
    // Each motor's zero is free.
    for (auto& x : left) x = without_columns(x, {std::vector<double>(x.size(), 1.0)});
    return left;
  }

  void scale_noise(double factor) override { sigma_ *= factor; }

  void measure(Table& log, int number) const override {
    Draw draw(streams_[static_cast<size_t>(number) % std::size(streams_)] ^ 0x5bd1e995u);
    for (size_t i = 0; i < tendons; ++i) {
      Noise noise(draw.fork());
      const double zero = draw.uniform(-1.0, 1.0);
      for (double& x : log.columns[3 + i]) x += zero + sigma_ * noise.next();
    }
    for (double& x : log.columns[1]) x += 2.0e-5 * draw.normal();
    for (double& x : log.columns[2]) x += 2.0e-5 * draw.normal();
  }

 private:
  WristModel model_;
  double sigma_ = 0.01, zero71_ = 0.0, zero73_ = 0.0;
  std::uint64_t streams_[4] = {};
  std::vector<WristCause> causes_;
  std::vector<Cause> listed_;
};

}  // namespace

std::unique_ptr<Plant> draw_wrist(Draw draw) {
  return std::make_unique<WristPlant>(draw);
}

}  // namespace sinew::truth

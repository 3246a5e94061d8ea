// SPDX-License-Identifier: GPL-3.0-or-later
// The wrist moves, the fingers are held and the tendons kept at their force: the motors follow the
// tendons.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/blind/truth/axis.h"
#include "tests/blind/truth/chain.h"
#include "tests/blind/truth/compared.h"
#include "tests/blind/truth/signal_path.h"
#include "tests/blind/truth/signals.h"
#include "tests/blind/truth/trial_plant.h"
#include "tests/blind/truth/wrist_shape.h"

namespace sinew::trials {
namespace {

using truth::Draw;

/// What is outside at a wrist: an angle that one motor or all of them turn more than they should.
/// Keeps what it remembers.
class Disturbed {
 public:
  Disturbed(const std::vector<Hidden>& hidden, Index motors) : hidden_(hidden), played_(motors) {
    played_.setZero();
  }

  /// theta of motor i at this time, `speed` of the wrist's flexion and abduction.
  double of(Index i, double theta, const Vector3d& where, const Vector3d& speed, double time,
            double step) {
    for (const Hidden& h : hidden_) {
      if (h.cause == "heat") theta *= 1.0 + h.dose * warm_;
      if (h.cause == "filling") theta += 0.02 * h.dose * where.y() * std::min(1.0, time / 10.0);
      if (h.cause == "latch") theta += h.dose * latched_;
      if (h.cause == "speed_memory") theta += h.dose * fastest_ * std::tanh(30.0 * speed.x());
      if (h.cause == "tight_under_load")
        theta += h.dose * std::sin(6.0 * where.y() + h.phase) * speed.x() * 0.2;
      if (h.cause == "outer_force" && h.at == i)
        theta += std::fmod(time, 4.6) < 2.3
                     ? h.dose * std::pow(std::sin(pi * std::fmod(time, 2.3) / 2.3), 2.0)
                     : 0.0;
      if (h.cause == "other_stage" && h.at == i)
        theta += h.dose * std::sin(0.5857 * 20.0 * theta + h.phase) *
                 (1.0 + 0.5 * std::sin(0.1716 * 20.0 * theta));
      if (h.cause == "loose_motor" && h.at == i && h.dose > 0.0) {
        played_(i) = std::clamp(played_(i), theta - 0.5 * h.dose, theta + 0.5 * h.dose);
        theta = played_(i);
      }
    }
    if (i == 0) remember(where, speed, step);
    return theta;
  }

 private:
  void remember(const Vector3d& where, const Vector3d& speed, double step) {
    warm_ += step / 8.0 * (speed.squaredNorm() - warm_);
    fastest_ = std::max(speed.norm(), fastest_ * std::exp(-step / 3.0));
    if (last_ * speed.y() < 0.0) {
      if (std::abs(where.y() - turned_) > 0.15) latched_ = last_ > 0.0 ? 1.0 : -1.0;
      turned_ = where.y();
    }
    last_ = speed.y();
  }
  const std::vector<Hidden>& hidden_;
  VectorXd played_;
  double warm_ = 0.0, fastest_ = 0.0, latched_ = 0.0, last_ = 0.0, turned_ = 0.0;
};

class WristPlant : public TrialPlant {
 public:
  explicit WristPlant(Draw draw) {
    for (auto& s : streams_) s = draw.bits();
    shape_.a *= draw.uniform(0.9, 1.1);
    shape_.b *= draw.uniform(0.9, 1.1);
    shape_.c *= draw.uniform(0.9, 1.1);
    motors_ = 4 + draw.below(5);
    noise_ = draw.uniform(4.0e-4, 2.0e-3);
    zero71_ = reference_71(shape_);
    zero73_ = reference_73(shape_);
    list_offers();
  }

  const std::vector<Offer>& offers() const override { return offers_; }
  void write_model(const std::filesystem::path& folder) const override {
    write_file(folder / "model" / "part.toml", wrist_part(shape_, motors_));
  }

  Course course(const std::vector<Hidden>&, int log) const override {
    Draw draw(streams_[log]);
    Course c;
    c.step = 0.002;
    const Index rows = 9000;
    c.q = c.v = c.a = MatrixXd::Zero(rows, 2);
    const double reach[] = {0.24, 0.28};
    for (Index j = 0; j < 2; ++j) {
      const auto table =
          truth::Motion(truth::Course::mixed, reach[j], 3.0 * reach[j], 18.0, draw.fork())
              .table(c.step, static_cast<std::size_t>(rows));
      for (Index k = 0; k < rows; ++k) {
        const truth::Reference& r = table[static_cast<std::size_t>(k)];
        c.q(k, j) = (j == 0 ? zero71_ : zero73_) + r.position;
        c.v(k, j) = r.velocity;
      }
    }
    return c;
  }

  Log replay(const Course& course, const std::vector<Hidden>& hidden, int number) const override {
    Log log;
    log.step = course.step;
    const Index rows = course.q.rows(), m = motors_;
    log.columns.resize(rows, 2 + m);
    log.names = {"q71", "q73"};
    for (Index i = 0; i < m; ++i) log.names.push_back(fmt::format("theta_{}", i + 1));
    log.units.assign(log.names.size(), "rad");
    Disturbed disturbed(hidden, m);
    std::vector<Vector3d> first(static_cast<std::size_t>(m));
    VectorXd start(m);
    double share = 0.0, contact = 0.0;
    std::array<double, 2> zero{}, scale{}, coarse{};
    for (const Hidden& h : hidden) {
      const auto at = static_cast<std::size_t>(std::min(h.at, 1));
      if (h.cause == "wrist_coupling") share = h.dose;
      if (h.cause == "contact_shift") contact = h.dose;
      if (h.cause == "wrist_zero") zero[at] = h.dose;
      if (h.cause == "sensor_scale") scale[at] = h.dose;
      if (h.cause == "sensor_quantisation") coarse[at] = h.dose;
    }
    const double reference[] = {zero71_, zero73_};
    // Where each motor counts from: it is fitted in any case, and no noise.
    Draw counted(streams_[number] ^ 0x2545f491u);
    VectorXd from(m);
    for (double& x : from) x = counted.uniform(-1.0, 1.0);
    // The reference pose, from which a tendon's bend at its guides counts.
    const PalmPose rest = palm_pose(shape_, zero71_, zero73_);
    for (Index k = 0; k < rows; ++k) {
      const PalmPose pose = palm_pose(shape_, course.q(k, 0), course.q(k, 1));
      for (std::size_t j = 0; j < 2; ++j) {
        double q = course.q(k, static_cast<Index>(j)) - zero[j];
        q = reference[j] + (q - reference[j]) * (1.0 + scale[j]);
        if (coarse[j] > 0.0) q = coarse[j] * std::round(q / coarse[j]);
        log.columns(k, static_cast<Index>(j)) = q;
      }
      for (Index i = 0; i < m; ++i) {
        const auto span_of = [&](const PalmPose& p) -> Vector3d {
          return p.rotation * palm_point(static_cast<int>(i)) + p.origin -
                 forearm_point(static_cast<int>(i));
        };
        const Vector3d span = span_of(pose), before = span_of(rest);
        const double turned = std::atan2(span.cross(before).norm(), span.dot(before));
        double length = (span.norm() - before.norm()) + contact * turned;
        length *= 1.0 - share;
        double radius = shape_.motor_radius;
        for (const Hidden& h : hidden)
          if (h.cause == "tendon_radius" && h.at == i) radius *= 1.0 + h.dose;
        const Vector3d where(course.q(k, 0) - zero71_, course.q(k, 1) - zero73_, 0.0);
        const Vector3d speed(course.v(k, 0), course.v(k, 1), 0.0);
        log.columns(k, 2 + i) =
            from(i) + disturbed.of(i, -length / radius, where, speed,
                                   course.step * static_cast<double>(k), course.step);
      }
    }
    for (int j = 0; j < 2; ++j) {
      std::vector<Hidden> here = only_at(hidden, j);
      std::erase_if(here, [](const Hidden& h) {
        return h.cause != "sensor_low_pass" && h.cause != "sensor_hysteresis";
      });
      log.columns.col(j) = sensed_position(log.columns.col(j), here, log.step);
    }
    return log;
  }

  void measure(Log& log, int number) const override {
    Draw draw(streams_[number] ^ 0x5bd1e995u);
    for (Index i = 0; i < motors_; ++i) {
      truth::Noise noise(draw.fork());
      for (double& x : log.columns.col(2 + i)) x += noise_ * noise.next();
    }
    for (Index j = 0; j < 2; ++j)
      for (double& x : log.columns.col(j)) x += 2.0e-5 * draw.normal();
  }

  std::vector<VectorXd> left_over(const Log& log) const override {
    std::vector<VectorXd> left(static_cast<std::size_t>(motors_), VectorXd(log.columns.rows()));
    for (Index k = 0; k < log.columns.rows(); ++k) {
      const PalmPose pose = palm_pose(shape_, log.columns(k, 0), log.columns(k, 1));
      for (int i = 0; i < motors_; ++i) {
        const double length =
            (pose.rotation * palm_point(i) + pose.origin - forearm_point(i)).norm();
        left[static_cast<std::size_t>(i)](k) = log.columns(k, 2 + i) + length / shape_.motor_radius;
      }
    }
    return left;
  }

  std::vector<MatrixXd> fitted(const Log& log, unsigned) const override {
    // Each motor's zero is free.
    return std::vector<MatrixXd>(static_cast<std::size_t>(motors_),
                                 MatrixXd::Ones(log.columns.rows(), 1));
  }
  std::vector<VectorXd> moving(const Log& log) const override {
    return std::vector<VectorXd>(static_cast<std::size_t>(motors_),
                                 VectorXd::Ones(log.columns.rows()));
  }
  std::vector<double> bands(const Log& log, const Log&) const override {
    return std::vector<double>(static_cast<std::size_t>(motors_), rig_band(log.step));
  }

 private:
  void list_offers() {
    const auto offer = [&](const char* cause, const std::string& place, int at, double scale,
                           bool outside, const char* parameter = "") {
      offers_.push_back({cause, place, at, scale, outside, fits_all, parameter, 1.0, 0});
    };
    offer("wrist_coupling", "wrist", 0, 1.0, false, "share");
    offer("contact_shift", "wrist", 0, 1e-3, false, "radius");
    for (int j = 0; j < 2; ++j) {
      const std::string place = j == 0 ? "q71" : "q73";
      offer("wrist_zero", place, j, 1.0, false, "offset");
      offer("sensor_scale", place, j, 1.0, false, "scale_error");
      offer("sensor_quantisation", place, j, 1.0, false);
      offer("sensor_low_pass", place, j, 1.0, false);
      offer("sensor_hysteresis", place, j, 1.0, false);
    }
    for (int i = 0; i < motors_; ++i) {
      const std::string place = fmt::format("motor {}", i + 1);
      offer("tendon_radius", place, i, 1.0, false, "change");
      for (const char* cause : {"outer_force", "other_stage", "loose_motor"})
        offer(cause, place, i, 1.0, true);
    }
    for (const char* cause : {"heat", "filling", "latch", "speed_memory", "tight_under_load"})
      offer(cause, "wrist", 0, cause == std::string("filling") ? 10.0 : 1.0, true);
  }

  WristShape shape_;
  int motors_ = 8;
  double noise_ = 0.005, zero71_ = 0.0, zero73_ = 0.0;
  std::uint64_t streams_[4] = {};
  std::vector<Offer> offers_;
};

}  // namespace

std::unique_ptr<TrialPlant> draw_wrist(Draw draw) {
  return std::make_unique<WristPlant>(draw);
}

}  // namespace sinew::trials

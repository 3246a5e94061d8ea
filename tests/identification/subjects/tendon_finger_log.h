// SPDX-License-Identifier: GPL-3.0-or-later
// A log of the index finger by the forces of its tendons and by its motors, without a fault.
#pragma once

#include <fmt/format.h>

#include <Eigen/QR>
#include <functional>
#include <numbers>
#include <string>

#include "identification/logs/log.h"
#include "identification/subjects/driven_subject.h"
#include "identification/subjects/tendon_candidates.h"
#include "tests/identification/subjects/finger_with_motors.h"
#include "tests/reference/random_numbers.h"

namespace sinew::test {

/// A finger's log: all forces keep near 20 N and carry the joints, motors go their own ways.
class TendonFingerLog {
 public:
  static constexpr Eigen::Index joints = 4, tendons = 8, rows = 8000;

  TendonFingerLog() : model_(finger_with_motors()), effort_(model_, {}, runtime()) {
    for (Eigen::Index c = 0; c < joints; ++c) columns_.positions.push_back(add("q", c, "rad"));
    for (Eigen::Index t = 0; t < tendons; ++t) columns_.forces.push_back(add("force_", t, "N"));
    for (Eigen::Index t = 0; t < tendons; ++t)
      columns_.positions.push_back(add("theta_", t, "rad"));
    for (Eigen::Index t = 0; t < tendons; ++t) columns_.efforts.push_back(add("tau_", t, "N*m"));
    log_.segments.resize(1);
    move();
    carry();
  }

  /// As add_log() would make it of these columns, something planted in them.
  diagnosis::Recording with(const std::function<void(diagnosis::Recording&)>& plant) const {
    diagnosis::Recording r = right_;
    plant(r);
    diagnosis::TendonColumns(model_, runtime()).add_signals(r);
    return r;
  }

  const Log& log() const { return log_; }
  const diagnosis::DrivenColumns& columns() const { return columns_; }
  const DrivenModel& model() const { return model_; }
  const diagnosis::EffortModel& effort() const { return effort_; }

 private:
  static const char* runtime() { return SINEW_SOURCE_DIR "/runtime"; }

  int add(const std::string& name, Eigen::Index number, const std::string& unit) {
    Channel channel;
    channel.name = fmt::format("{}{}", name, number + 1);
    channel.unit = unit;
    channel.column = static_cast<int>(log_.channels.size()) + 2;
    log_.channels.push_back(channel);
    return static_cast<int>(log_.channels.size()) - 1;
  }

  void move() {
    reference::RandomNumbers random(3);
    right_.step = 0.001;
    right_.time = Eigen::VectorXd::LinSpaced(rows, 0.0, 0.001 * static_cast<double>(rows - 1));
    right_.q = right_.qd = right_.qdd = Eigen::MatrixXd::Zero(rows, joints + tendons);
    for (Eigen::Index c = 0; c < right_.q.cols(); ++c)
      for (int i = 0; i < 3; ++i) {
        const double w = 2.0 * std::numbers::pi * random.uniform(0.2, 1.5),
                     size = c == 0 ? 0.08 : 0.2;
        const auto angle = (w * right_.time.array() + random.uniform(0.0, 6.28)).eval();
        right_.q.col(c).array() += size * angle.sin();
        right_.qd.col(c).array() += size * w * angle.cos();
        right_.qdd.col(c).array() -= size * w * w * angle.sin();
      }
    right_.q.block(0, 1, rows, joints - 1).array() += 0.8;
  }

  void carry() {
    right_.signals["tension"] = Eigen::MatrixXd::Constant(rows, tendons, 20.0);
    right_.load = Eigen::MatrixXd::Zero(rows, joints + tendons);
    const diagnosis::TendonColumns columns(model_, runtime());
    columns.add_signals(right_);
    const Eigen::MatrixXd asked = effort_(right_).leftCols(joints);
    const Eigen::MatrixXd missing = asked - columns.joint_torque(right_);
    const Eigen::MatrixXd& arms = right_.signals.at("moment_arm");
    for (Eigen::Index k = 0; k < rows; ++k) {
      Eigen::MatrixXd p(joints, tendons);
      for (Eigen::Index t = 0; t < tendons; ++t)
        p.col(t) = -arms.row(k).segment(t * joints, joints).transpose();
      right_.signals["tension"].row(k) +=
          Eigen::VectorXd(p.completeOrthogonalDecomposition().solve(missing.row(k).transpose()))
              .transpose();
    }
    right_.load.rightCols(tendons) =
        model_.tendons.motor->pulley_radius * right_.signals["tension"];
    const Eigen::MatrixXd efforts = effort_(right_);
    for (Eigen::Index c = 0; c < efforts.cols(); ++c) right_.target.push_back(efforts.col(c));
  }

  DrivenModel model_;
  diagnosis::EffortModel effort_;
  Log log_;
  diagnosis::DrivenColumns columns_;
  diagnosis::Recording right_;
};

}  // namespace sinew::test

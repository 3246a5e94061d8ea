// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/wrist_drive.h"

#include <fmt/format.h>

#include <stdexcept>

#include "generator/assemble.h"

namespace sinew {
namespace {

/// Points of the difference quotients in time: errors are of their fourth power.
constexpr int points = 5;
constexpr int lanes = 8;  // of the emitted loop: a whole vector costs less than five states
constexpr int middle = 2;
constexpr double spacing = 5e-4;  // s

double along(const Sample& sample, double time) {
  return sample.value + time * (sample.rate + 0.5 * time * sample.acceleration);
}

}  // namespace

WristDrive::WristDrive(const WristParameters& parameters, const std::filesystem::path& runtime)
    : model_(assemble({"wrist", "", "", {}},
                      {wrist_bar_angles(parameters), wrist_feedforward(parameters),
                       wrist_feedforward_rate(parameters)},
                      {}),
             runtime, true),
      bar_angles_(model_.batch<BarAngles>("bar_angles")),
      feedforward_(&model_.find("feedforward")),
      feedforward_rate_(&model_.find("feedforward_rate")) {}

WristMotion WristDrive::at(const Sample& flexion, const Sample& abduction) const {
  double f[lanes], a[lanes], q[2 * lanes], residual[lanes], status[lanes];
  for (int i = 0; i < lanes; ++i) {
    const double time = i < points ? (i - middle) * spacing : 0.0;
    f[i] = along(flexion, time);
    a[i] = along(abduction, time);
  }
  bar_angles_(lanes, f, a, q, residual, status);
  if (status[middle] != 0.0)
    throw std::domain_error(
        fmt::format("the wrist cannot reach flexion {:.4g} rad, abduction {:.4g} rad",
                    flexion.value, abduction.value));
  WristMotion motion;
  const bool rests = flexion.rate == 0.0 && abduction.rate == 0.0 && flexion.acceleration == 0.0 &&
                     abduction.acceleration == 0.0;
  for (int i = 0; i < 2; ++i) {
    const double* p = q + lanes * i;
    motion.q[i] = p[middle];
    if (rests) continue;
    motion.qd[i] = (p[0] - 8 * p[1] + 8 * p[3] - p[4]) / (12 * spacing);
    motion.qdd[i] = (-p[0] + 16 * p[1] - 30 * p[2] + 16 * p[3] - p[4]) / (12 * spacing * spacing);
  }
  return motion;
}

void WristDrive::feedforward(const WristMotion& wrist, double* delta, double* rate) const {
  const double in[4] = {wrist.q[0], wrist.q[1], wrist.qd[0], wrist.qd[1]};
  feedforward_->call(in, delta);
  feedforward_rate_->call(in, rate);
}

}  // namespace sinew

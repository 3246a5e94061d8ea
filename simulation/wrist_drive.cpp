// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/wrist_drive.h"

#include <fmt/format.h>

#include <stdexcept>

#include "generator/assemble.h"

namespace sinew {
namespace {

constexpr double rate_step = 1e-5;  // s

}  // namespace

WristDrive::WristDrive(const WristParameters& parameters, const std::filesystem::path& runtime)
    : model_(assemble({"wrist", "", "", {}}, wrist_functions(parameters), {}), runtime),
      bar_angles_(&model_.find("bar_angles")),
      feedforward_(&model_.find("feedforward")),
      feedforward_rate_(&model_.find("feedforward_rate")) {}

void WristDrive::bar_angles(double flexion, double abduction, double* q) const {
  const double in[2] = {flexion, abduction};
  double out[4];
  bar_angles_->call(in, out);
  if (out[3] != 0.0)
    throw std::domain_error(fmt::format(
        "the wrist cannot reach flexion {:.4g} rad, abduction {:.4g} rad", flexion, abduction));
  q[0] = out[0];
  q[1] = out[1];
}

WristMotion WristDrive::at(const Sample& flexion, const Sample& abduction) const {
  WristMotion motion;
  bar_angles(flexion.value, abduction.value, motion.q);
  if (flexion.rate == 0.0 && abduction.rate == 0.0) return motion;
  double before[2], after[2];
  bar_angles(flexion.value - rate_step * flexion.rate, abduction.value - rate_step * abduction.rate,
             before);
  bar_angles(flexion.value + rate_step * flexion.rate, abduction.value + rate_step * abduction.rate,
             after);
  for (int i = 0; i < 2; ++i) motion.qd[i] = (after[i] - before[i]) / (2 * rate_step);
  return motion;
}

void WristDrive::feedforward(const WristMotion& wrist, double* delta, double* rate) const {
  const double in[4] = {wrist.q[0], wrist.q[1], wrist.qd[0], wrist.qd[1]};
  feedforward_->call(in, delta);
  feedforward_rate_->call(in, rate);
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drives/wrist_drive.h"

#include <fmt/format.h>

#include <stdexcept>

#include "generator/assemble.h"

namespace sinew {
namespace {

/// Points of the difference quotients in time: errors are of their fourth power.
constexpr int points = 5;
constexpr int vector_width = 8;  // of the emitted loop: a whole vector costs less than five states
constexpr int middle = 2;
constexpr double spacing = 5e-4;  // s

constexpr double between_knots = 1e-3;  // s

Sample sample_of(const Signal* signal, double time) {
  return signal ? signal->at(time) : Sample{};
}

/// Between two motions `h` apart, at the share `s` of the way.
WristMotion between(const WristMotion& a, const WristMotion& b, double h, double s) {
  WristMotion motion;
  for (int i = 0; i < 2; ++i) {
    const double c1 = h * a.qd[i], c2 = 0.5 * h * h * a.qdd[i];
    const double d = b.q[i] - a.q[i] - c1 - c2, e = h * b.qd[i] - c1 - 2 * c2,
                 f = h * h * b.qdd[i] - 2 * c2;
    const double c3 = 10 * d - 4 * e + 0.5 * f, c4 = -15 * d + 7 * e - f,
                 c5 = 6 * d - 3 * e + 0.5 * f;
    motion.q[i] = a.q[i] + s * (c1 + s * (c2 + s * (c3 + s * (c4 + s * c5))));
    motion.qd[i] = (c1 + s * (2 * c2 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h;
    motion.qdd[i] = (2 * c2 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / (h * h);
  }
  return motion;
}

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
  double f[vector_width], a[vector_width], q[2 * vector_width], residual[vector_width];
  int status[vector_width];
  for (int i = 0; i < vector_width; ++i) {
    const double time = i < points ? (i - middle) * spacing : 0.0;
    f[i] = along(flexion, time);
    a[i] = along(abduction, time);
  }
  bar_angles_(vector_width, f, a, q, residual, status);
  if (status[middle] != 0)
    throw std::domain_error(
        fmt::format("the wrist cannot reach flexion {:.4g} rad, abduction {:.4g} rad",
                    flexion.value, abduction.value));
  WristMotion motion;
  const bool rests = flexion.rate == 0.0 && abduction.rate == 0.0 && flexion.acceleration == 0.0 &&
                     abduction.acceleration == 0.0;
  for (int i = 0; i < 2; ++i) {
    const double* p = q + vector_width * i;
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

const WristMotion& WristTrack::knot(const WristDrive& drive, const Signal* flexion,
                                    const Signal* abduction, long index) {
  Knot& knot = knots_[index % 2];
  if (knot.index == index) return knot.motion;
  const double time = static_cast<double>(index) * between_knots;
  knot.index = -1;  // stays so where the wrist cannot get there
  knot.motion = drive.at(sample_of(flexion, time), sample_of(abduction, time));
  knot.index = index;
  return knot.motion;
}

WristMotion WristTrack::at(const WristDrive& drive, const Signal* flexion, const Signal* abduction,
                           double time) {
  const bool smooth = (!flexion || flexion->smooth()) && (!abduction || abduction->smooth());
  if (smooth) try {
      const double place = time / between_knots;
      const long index = static_cast<long>(place);
      const WristMotion& before = knot(drive, flexion, abduction, index);
      return between(before, knot(drive, flexion, abduction, index + 1), between_knots,
                     place - static_cast<double>(index));
    } catch (const std::domain_error&) {
      // A knot may lie beyond what is asked for.
    }
  return drive.at(sample_of(flexion, time), sample_of(abduction, time));
}

}  // namespace sinew

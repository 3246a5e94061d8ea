// SPDX-License-Identifier: GPL-3.0-or-later
// One driven axis: friction with a memory, and what may act on it.
#pragma once

#include <vector>

#include "tests/blind/truth/hidden.h"

namespace sinew::trials {

/// The scales of an axis, and the friction that the model under test knows of.
struct AxisModel {
  double level = 0.1;    ///< friction at high speed, without the viscous part
  double turning = 0.0;  ///< speed at which half of it acts; 0: it turns with the bristles alone
  double viscous = 0.01;
  double inertia = 1.0;  ///< that the axis carries, at rest in the middle
  double effort = 1.0;   ///< rms of what the work takes
  double range = 1.0;    ///< half of the positions that motions use
  double top_speed = 1.0;
  double motor_turn = 0.0, output_turn = 0.0;
};

/// Pre-sliding: the way until friction is full, and the law by which it gets there.
struct Bristle {
  double way = 1.0e-6;
  int law = 0;  ///< 0 exponential (Dahl), 1 Bouc-Wen, 2 LuGre with a share of bristle damping
};

class Axis {
 public:
  Axis(AxisModel model, Bristle bristle, std::vector<Hidden> hidden);

  /// Effort against the motion, inertia apart: to be called for one step after the other.
  double resist(const Instant& now, double step);
  /// The same, and nothing has happened.
  double would_resist(const Instant& now, double step);
  /// Derivative of the last effort by the speed, for steps that take friction implicitly.
  double slope(double v, double step) const;
  const AxisModel& model() const { return model_; }

 private:
  void turn(double v, double step);
  double sliding(double speed) const;
  double of(const Hidden& h, const Instant& now, double step);
  double friction_of(const Hidden& h, const Instant& now) const;
  double place_of(const Hidden& h, const Instant& now) const;
  double outside_of(const Hidden& h, const Instant& now);

  AxisModel model_;
  Bristle bristle_;
  std::vector<Hidden> hidden_;
  struct Memory {
    double z = 0.0, last_z = 0.0;
    double fastest = 0.0, latched = 0.0, turned_at = 0.0, last_v = 0.0;
    std::uint64_t strokes = 0;  ///< since the start: changes of the direction
    double sheared = 0.0;       ///< share of the grease that motion has broken down
  } memory_;
};

/// Whether this cause acts on the axis as an effort.
bool acts_on_axis(const std::string& cause);

}  // namespace sinew::trials

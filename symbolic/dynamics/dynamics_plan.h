// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "symbolic/dynamics/joint_tree.h"

namespace sinew {

/// How the equations of one joint and its link are written. Every choice gives the same function;
/// they differ in the number of operations, so the program tries them (see choose_plan).
struct JointPlan {
  FrameChoice frame;
  /// Join the parent's run of parallel axes: one frame that does not turn, angles summed.
  bool join_run = true;
  /// Write a joint without parallel neighbours as a run of one: its link's constants are turned
  /// instead of the motion.
  bool lone_run = false;
  /// Keep a run's frame {P} at the carrier's origin (but for the height along the axes) instead of
  /// on the first axis: the offset then enters the composites and the carrier's motion is used as
  /// is.
  bool keep_carrier_origin = false;
  /// Couple the links of a run pair by pair instead of passing accelerations out and forces in:
  /// cheaper for short runs without joint accelerations.
  bool pair_by_pair = false;
};

/// One entry a moving joint, in coordinate order.
using DynamicsPlan = std::vector<JointPlan>;

/// The frame choices of a plan.
std::vector<FrameChoice> frames_of(const DynamicsPlan& plan);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "symbolic/dynamics/dynamics_plan.h"
#include "symbolic/dynamics/joint_tree.h"

namespace sinew {

/// Links that turn about parallel axes and are described in one common frame {P}: the frame of the
/// first joint before its motion, fixed in the link that carries the run.
struct Run {
  std::vector<int> links;             ///< parents before children; the first one is the root
  bool common_frame;                  ///< false: a single link in its own frame
  NumberVector3 origin;               ///< origin of {P} in the carrier's frame, m
  std::array<Number, 2> root_offset;  ///< the first axis in {P}, m
  bool pair_by_pair = false;
};

struct Runs {
  std::vector<Run> runs;    ///< parents before children
  std::vector<int> run_of;  ///< link -> run
};

/// Splits the tree into runs as the plan says.
Runs split_into_runs(const JointTree& tree, const DynamicsPlan& plan);

}  // namespace sinew

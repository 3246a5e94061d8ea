// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/runs.h"

namespace sinew {

std::vector<FrameChoice> frames_of(const DynamicsPlan& plan) {
  std::vector<FrameChoice> frames;
  for (const JointPlan& joint : plan) frames.push_back(joint.frame);
  return frames;
}

Runs split_into_runs(const JointTree& tree, const DynamicsPlan& plan) {
  Runs result;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink& link = tree.links[i];
    const JointPlan choice = i < plan.size() ? plan[i] : JointPlan{};
    if (link.parallel_to_parent && choice.join_run) {
      const int run = result.run_of[static_cast<std::size_t>(link.parent)];
      result.runs[static_cast<std::size_t>(run)].links.push_back(static_cast<int>(i));
      result.runs[static_cast<std::size_t>(run)].common_frame = true;
      result.run_of.push_back(run);
      continue;
    }
    result.run_of.push_back(static_cast<int>(result.runs.size()));
    result.runs.push_back(
        {{static_cast<int>(i)}, choice.lone_run && link.type == JointType::revolute});
  }
  return result;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/runs.h"

namespace sinew {

std::vector<FrameChoice> frames_of(const DynamicsPlan& plan) {
  std::vector<FrameChoice> frames;
  for (const JointPlan& joint : plan) frames.push_back(joint.frame);
  return frames;
}

namespace {

/// Takes over what the plan says of the whole run: moves {P} from the first axis back to the
/// carrier's origin where the plan asks for it.
void place_origin(Run& run, const JointTree& tree, const DynamicsPlan& plan) {
  const auto first = static_cast<std::size_t>(run.links[0]);
  if (!run.common_frame || first >= plan.size()) return;
  run.pair_by_pair = plan[first].pair_by_pair;
  if (!plan[first].keep_carrier_origin) return;
  const TreeLink& link = tree.links[first];
  const NumberVector3 in_P = link.R.transpose() * link.p;
  run.origin = link.R.col(2) * in_P(2);
  run.root_offset = {in_P(0), in_P(1)};
}

}  // namespace

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
    const bool common = choice.lone_run && link.type == JointType::revolute;
    result.runs.push_back({{static_cast<int>(i)}, common, link.p, {Number(0), Number(0)}});
  }
  for (Run& run : result.runs) place_origin(run, tree, plan);
  return result;
}

}  // namespace sinew

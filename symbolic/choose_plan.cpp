// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/choose_plan.h"

#include <vector>

namespace sinew {
namespace {

/// All alternatives for one joint; those that make no difference are left out.
std::vector<JointPlan> alternatives(const JointPlan& now, const TreeLink& link) {
  std::vector<JointPlan> result;
  if (link.type == JointType::prismatic) return result;
  const auto add = [&](auto change) {
    JointPlan plan = now;
    change(plan);
    result.push_back(plan);
  };
  if (link.children.empty()) {
    for (LeafTurn leaf :
         {LeafTurn::none, LeafTurn::no_first_moment_y, LeafTurn::no_product_of_inertia})
      if (leaf != now.frame.leaf) add([&](JointPlan& p) { p.frame.leaf = leaf; });
  } else if (!link.parallel_to_parent) {
    add([&](JointPlan& p) {
      p.frame.origin = p.frame.origin == OriginChoice::incoming ? OriginChoice::outgoing
                                                                : OriginChoice::incoming;
    });
  }
  if (link.parallel_to_parent) add([&](JointPlan& p) { p.join_run = !p.join_run; });
  add([](JointPlan& p) { p.lone_run = !p.lone_run; });
  add([](JointPlan& p) { p.pair_by_pair = !p.pair_by_pair; });
  add([](JointPlan& p) { p.keep_carrier_origin = !p.keep_carrier_origin; });
  add([](JointPlan& p) { p.lone_run = p.keep_carrier_origin = true; });
  return result;
}

}  // namespace

DynamicsPlan choose_plan(
    const Mechanism& mechanism,
    const std::function<Function(const JointTree&, const DynamicsPlan&)>& derive,
    const CostOf& cost, int most_joints) {
  const JointTree tree = build_joint_tree(mechanism);
  DynamicsPlan best(tree.links.size());
  if (!cost || static_cast<int>(tree.links.size()) > most_joints) return best;
  const auto price = [&](const DynamicsPlan& plan) {
    return cost(derive(build_joint_tree(mechanism, frames_of(plan)), plan));
  };
  double least = price(best);
  for (bool improved = true; improved;) {
    improved = false;
    for (std::size_t i = tree.links.size(); i-- > 0;)
      for (const JointPlan& alternative : alternatives(best[i], tree.links[i])) {
        DynamicsPlan plan = best;
        plan[i] = alternative;
        const double now = price(plan);
        if (now >= least) continue;
        least = now;
        best = plan;
        improved = true;
      }
  }
  return best;
}

}  // namespace sinew

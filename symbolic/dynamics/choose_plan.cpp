// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/choose_plan.h"

#include <vector>

namespace sinew {
namespace {

bool joins_parent(const JointTree& tree, const DynamicsPlan& plan, std::size_t i) {
  return tree.links[i].parallel_to_parent && plan[i].join_run;
}

bool is_joined_by_child(const JointTree& tree, const DynamicsPlan& plan, std::size_t i) {
  for (int child : tree.links[i].children)
    if (joins_parent(tree, plan, static_cast<std::size_t>(child))) return true;
  return false;
}

/// All alternatives for joint `i`; those that make no difference are left out.
std::vector<JointPlan> alternatives(const JointTree& tree, const DynamicsPlan& plan,
                                    std::size_t i) {
  const JointPlan& now = plan[i];
  const TreeLink& link = tree.links[i];
  std::vector<JointPlan> result;
  if (link.type == JointType::prismatic) return result;
  const auto add = [&](auto change) {
    JointPlan other = now;
    change(other);
    result.push_back(other);
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
  if (joins_parent(tree, plan, i)) return result;  // the rest is said by the run's first joint
  const bool joined = is_joined_by_child(tree, plan, i);
  if (!joined) add([](JointPlan& p) { p.lone_run = !p.lone_run; });
  if (joined || now.lone_run) {
    add([](JointPlan& p) { p.pair_by_pair = !p.pair_by_pair; });
    add([](JointPlan& p) { p.keep_carrier_origin = !p.keep_carrier_origin; });
  } else {
    add([](JointPlan& p) { p.lone_run = p.keep_carrier_origin = true; });
  }
  return result;
}

}  // namespace

PlanSearch::PlanSearch(const Mechanism& mechanism, CostOf cost, int most_joints)
    : mechanism_(mechanism),
      cost_(std::move(cost)),
      plan_(build_joint_tree(mechanism).links.size()) {
  search_ = static_cast<bool>(cost_) && static_cast<int>(plan_.size()) <= most_joints;
}

const JointTree& PlanSearch::tree_of(const DynamicsPlan& plan) {
  std::vector<int> key;
  for (const FrameChoice& frame : frames_of(plan)) {
    key.push_back(static_cast<int>(frame.origin));
    key.push_back(static_cast<int>(frame.leaf));
  }
  const auto found = trees_.find(key);
  if (found != trees_.end()) return found->second;
  return trees_.emplace(key, build_joint_tree(mechanism_, frames_of(plan))).first->second;
}

bool PlanSearch::improve(const Derivation& derive, std::size_t i, double& least) {
  bool improved = false;
  for (const JointPlan& alternative : alternatives(tree_of(plan_), plan_, i)) {
    const bool own_frame = alternative.frame.leaf != LeafTurn::none ||
                           alternative.frame.origin != OriginChoice::incoming;
    if (masses_open_ && own_frame) continue;
    DynamicsPlan changed = plan_;
    changed[i] = alternative;
    const double price = cost_(derive(tree_of(changed), changed));
    if (price >= least) continue;
    least = price;
    plan_ = changed;
    improved = true;
  }
  return improved;
}

Function PlanSearch::cheapest(const Derivation& derive) {
  if (search_) {
    double least = cost_(derive(tree_of(plan_), plan_));
    // from the tips to the base and again, until no joint since the last gain has brought another
    for (std::size_t i = 0, settled = 0; settled < plan_.size();) {
      i = (i > 0 ? i : plan_.size()) - 1;
      settled = improve(derive, i, least) ? 0 : settled + 1;
    }
  }
  return derive(tree_of(plan_), plan_);
}

}  // namespace sinew

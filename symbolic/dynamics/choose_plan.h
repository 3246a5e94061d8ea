// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "generator/function.h"
#include "symbolic/dynamics/dynamics_plan.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// What a function costs once it is optimised; smaller is better. Comes from the generator, so that
/// the derivation chooses by what is emitted and still knows nothing of C.
using CostOf = std::function<double(const Function&)>;

/// Writes one function by a plan.
using Derivation = std::function<Function(const JointTree&, const DynamicsPlan&)>;

/// Finds the plan by which a mechanism's functions get cheapest. Deterministic.
class PlanSearch {
 public:
  /// Without a cost, or with more than `most_joints` joints, every function gets the default plan.
  PlanSearch(const Mechanism& mechanism, CostOf cost, int most_joints = 8);

  /// Keeps every function in the default frames: their parameters are then the same numbers, and
  /// no choice depends on the values of masses.
  void keep_masses_open() { masses_open_ = true; }

  /// The function in its cheapest form: joint by joint, a choice is kept where it makes the
  /// function cheaper, until none does. Starts from the plan found last, since functions of one
  /// mechanism mostly agree.
  Function cheapest(const Derivation& derive);

  /// The function by the plan found last, without a search of its own.
  Function by_last_plan(const Derivation& derive) { return derive(tree_of(plan_), plan_); }

 private:
  const JointTree& tree_of(const DynamicsPlan& plan);
  /// Keeps what makes the function cheaper among the alternatives for joint `i`.
  bool improve(const Derivation& derive, std::size_t i, double& least);

  const Mechanism& mechanism_;
  CostOf cost_;
  DynamicsPlan plan_;
  bool search_;
  bool masses_open_ = false;
  std::map<std::vector<int>, JointTree> trees_;  // by frame choices
};

}  // namespace sinew

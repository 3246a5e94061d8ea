// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/dynamics/composite_inertia.h"
#include "symbolic/expressions/definition_list.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/run_geometry.h"
#include "symbolic/dynamics/runs.h"

namespace sinew {

/// Inertia of all masses beyond each joint, gathered from the tips to the base.
class Composites {
 public:
  /// `angles`: one a link (joint_angles.h); `q`: positions of the tree's coordinates.
  Composites(DefinitionList& list, const JointTree& tree, const Runs& runs,
             const std::vector<CosSin>& angles, const std::vector<GiNaC::ex>& q);

  /// A link with all it carries, about its origin and in its axes; of a link in a common frame only
  /// what is carried by other runs.
  const PseudoInertia& beyond(int link) const { return inertias_[static_cast<std::size_t>(link)]; }

  /// The same behind a link in its own frame, in the joint's frame before its motion.
  const PseudoInertia& before(int link) const { return before_[static_cast<std::size_t>(link)]; }

  /// The links of a run in a common frame.
  const std::vector<RunLink>& run(std::size_t index) const { return geometry_[index]; }

 private:
  const TreeLink& link(int i) const { return tree_.links[static_cast<std::size_t>(i)]; }
  void close_own_frame(const Run& run);
  void close_common_frame(std::size_t index);
  void add_to_carrier(const Run& run, const PseudoInertia& J);

  DefinitionList& list_;
  const JointTree& tree_;
  const Runs& runs_;
  const std::vector<CosSin>& angles_;
  const std::vector<GiNaC::ex>& q_;
  std::vector<PseudoInertia> inertias_, before_;
  std::vector<std::vector<RunLink>> geometry_;
};

}  // namespace sinew

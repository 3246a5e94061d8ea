// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/recursive_lagrangian.h"

#include <optional>

#include "symbolic/dynamics/joint_angles.h"
#include "symbolic/dynamics/link_motion.h"
#include "symbolic/dynamics/parallel_run.h"

namespace sinew {
namespace {

using GiNaC::ex;

class Sweep {
 public:
  Sweep(DefinitionList& list, const JointTree& tree, const DynamicsPlan& plan,
        const JointState& state)
      : list_(list),
        tree_(tree),
        state_(state),
        runs_(split_into_runs(tree, plan)),
        angles_(joint_angles(list, tree, runs_, state.q)),
        motions_(tree.links.size()),
        wrenches_(tree.links.size(), Wrench{zero_vector(), zero_vector()}),
        parallel_(runs_.runs.size()) {}

  std::vector<ex> run() {
    std::vector<ex> tau(tree_.links.size());
    for (std::size_t r = 0; r < runs_.runs.size(); ++r) move_outward(r);
    for (std::size_t r = runs_.runs.size(); r-- > 0;) {
      const Wrench wrench =
          runs_.runs[r].common_frame ? close_common_frame(r, tau) : close_own_frame(r, tau);
      hand_to_carrier(r, wrench);
    }
    return tau;
  }

 private:
  const TreeLink& root(std::size_t r) const {
    return tree_.links[static_cast<std::size_t>(runs_.runs[r].links[0])];
  }

  bool carries_other_runs(int link) const {
    for (int child : tree_.links[static_cast<std::size_t>(link)].children)
      if (runs_.run_of[static_cast<std::size_t>(child)] !=
          runs_.run_of[static_cast<std::size_t>(link)])
        return true;
    return false;
  }

  void move_outward(std::size_t r) {
    const Run& run = runs_.runs[r];
    const TreeLink& first = root(r);
    const std::string name = std::to_string(run.links[0] + 1);
    const Motion carrier = first.parent < 0 ? motion_at_rest(tree_.gravity_vector)
                                            : motions_[static_cast<std::size_t>(first.parent)];
    const Motion base = fixed_frame_motion(list_, name, carrier, first.R, run.origin);
    if (run.common_frame) {
      std::vector<PseudoInertia> inertias;
      for (int link : run.links) inertias.push_back(tree_.inertias[static_cast<std::size_t>(link)]);
      parallel_[r].emplace(list_, tree_, run_geometry(list_, tree_, run, angles_, inertias),
                           run.pair_by_pair, base, state_.qd, state_.qdd);
      for (std::size_t k = 0; k < run.links.size(); ++k)
        if (carries_other_runs(run.links[k]))
          motions_[static_cast<std::size_t>(run.links[k])] =
              parallel_[r]->link_motion(static_cast<int>(k));
      return;
    }
    const auto c = static_cast<std::size_t>(first.coordinate);
    const ex qd = first.sign * state_.qd[c], qdd = first.sign * state_.qdd[c];
    Motion& motion = motions_[static_cast<std::size_t>(run.links[0])];
    motion = first.type == JointType::prismatic
                 ? slid_motion(list_, name, base, state_.q[c], qd, qdd)
                 : turned_motion(list_, name, base, angles_[static_cast<std::size_t>(run.links[0])],
                                 qd, qdd);
  }

  Wrench close_common_frame(std::size_t r, std::vector<ex>& tau) const {
    std::vector<Wrench> external;
    for (int link : runs_.runs[r].links)
      external.push_back(wrenches_[static_cast<std::size_t>(link)]);
    return parallel_[r]->close(external, tau);
  }

  /// Wrench of a lone link about its joint's frame before the motion.
  Wrench close_own_frame(std::size_t r, std::vector<ex>& tau) {
    const TreeLink& link = root(r);
    const auto i = static_cast<std::size_t>(runs_.runs[r].links[0]);
    const std::string name = std::to_string(i + 1);
    Wrench wrench = inertial_wrench(list_, name, tree_.inertias[i], motions_[i]);
    wrench = {named(list_, "F" + name, wrench.F + wrenches_[i].F),
              named(list_, "N" + name, wrench.N + wrenches_[i].N)};
    const bool slides = link.type == JointType::prismatic;
    tau[static_cast<std::size_t>(link.coordinate)] =
        link.sign * (slides ? wrench.F[2] : wrench.N[2]);
    if (slides) {
      const Vector3ex slide{ex(0), ex(0), state_.q[static_cast<std::size_t>(link.coordinate)]};
      return {wrench.F, wrench.N + cross(slide, wrench.F)};
    }
    return {turn(angles_[i], wrench.F), turn(angles_[i], wrench.N)};
  }

  void hand_to_carrier(std::size_t r, const Wrench& wrench) {
    const TreeLink& first = root(r);
    if (first.parent < 0) return;
    const std::string name = std::to_string(runs_.runs[r].links[0] + 1);
    const Wrench whole{named(list_, "P" + name, wrench.F), named(list_, "Q" + name, wrench.N)};
    add_wrench(list_, name, wrenches_[static_cast<std::size_t>(first.parent)], whole, first.R,
               to_expression(runs_.runs[r].origin));
  }

  DefinitionList& list_;
  const JointTree& tree_;
  const JointState& state_;
  Runs runs_;
  std::vector<CosSin> angles_;
  std::vector<Motion> motions_;
  std::vector<Wrench> wrenches_;
  std::vector<std::optional<ParallelRun>> parallel_;
};

}  // namespace

std::vector<ex> inverse_dynamics(DefinitionList& list, const JointTree& tree,
                                 const DynamicsPlan& plan, const JointState& state) {
  return Sweep(list, tree, plan, state).run();
}

}  // namespace sinew

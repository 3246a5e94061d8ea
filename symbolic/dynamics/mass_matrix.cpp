// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/mass_matrix.h"

#include "symbolic/dynamics/composites.h"
#include "symbolic/dynamics/joint_angles.h"
#include "symbolic/dynamics/link_motion.h"

namespace sinew {
namespace {

using GiNaC::ex;

class MassMatrixSweep {
 public:
  MassMatrixSweep(DefinitionList& list, const JointTree& tree, const DynamicsPlan& plan,
                  const std::vector<ex>& q)
      : list_(list),
        tree_(tree),
        q_(q),
        runs_(split_into_runs(tree, plan)),
        angles_(joint_angles(list, tree, runs_, q)),
        composites_(list, tree, runs_, angles_, q),
        n_(tree.links.size()),
        M_(n_ * n_, ex(0)) {}

  std::vector<ex> run() {
    for (std::size_t r = runs_.runs.size(); r-- > 0;) {
      if (runs_.runs[r].common_frame)
        close_common_frame(r);
      else
        close_own_frame(r);
    }
    return std::move(M_);
  }

 private:
  const TreeLink& link(int i) const { return tree_.links[static_cast<std::size_t>(i)]; }

  /// Origin of the frame in which a run's wrench is handed on, in its carrier.
  const NumberVector3& origin_of(int root) const {
    return runs_.runs[static_cast<std::size_t>(runs_.run_of[static_cast<std::size_t>(root)])]
        .origin;
  }

  void set(int i, int j, const ex& value) {
    const int sign = link(i).sign * link(j).sign;
    const auto row = static_cast<std::size_t>(link(i).coordinate),
               col = static_cast<std::size_t>(link(j).coordinate);
    const ex entry =
        named(list_, "M" + std::to_string(col + 1) + "_" + std::to_string(row + 1), sign * value);
    M_[row * n_ + col] = M_[col * n_ + row] = entry;
  }

  void close_own_frame(std::size_t r) {
    const int i = runs_.runs[r].links[0];
    const std::string name = std::to_string(i + 1);
    const PseudoInertia& J = composites_.beyond(i);
    Wrench column;
    if (link(i).type == JointType::prismatic) {
      column = {{ex(0), ex(0), J[3][3]}, {J[1][3], -J[0][3], ex(0)}};
      set(i, i, J[3][3]);
    } else {
      column = {{-J[1][3], J[0][3], ex(0)},
                {-J[0][2], -J[1][2], named(list_, "Z" + name, J[0][0] + J[1][1])}};
      set(i, i, column.N[2]);
      const CosSin& angle = angles_[static_cast<std::size_t>(i)];
      column = {named(list_, "cF" + name, turn(angle, column.F)),
                named(list_, "cN" + name, turn(angle, column.N))};
    }
    hand_to_carrier(i, i, column);
  }

  void close_common_frame(std::size_t r) {
    const std::vector<RunLink>& links = composites_.run(r);
    for (std::size_t k = links.size(); k-- > 0;) {
      const RunLink& at = links[k];
      ex inertia = at.Z;
      set(at.link, at.link, inertia);
      for (int j = static_cast<int>(k); links[static_cast<std::size_t>(j)].parent >= 0;) {
        const RunLink& before = links[static_cast<std::size_t>(j)];
        const ex lever = named(list_, "lS" + std::to_string(before.link + 1),
                               before.l[0] * at.S[0] + before.l[1] * at.S[1]);
        j = before.parent;
        inertia = named(list_, "M", inertia + lever);
        set(at.link, links[static_cast<std::size_t>(j)].link, inertia);
      }
      const ex N_z = named(list_, "cN", at.Z + at.o[0] * at.S[0] + at.o[1] * at.S[1]);
      hand_to_carrier(links[0].link, at.link,
                      {{-at.S[1], at.S[0], ex(0)}, {-at.K[0][2], -at.K[1][2], N_z}});
    }
  }

  /// Column of joint `i`, given in the frame of `root`'s run before motion, for all joints nearer
  /// to the base.
  void hand_to_carrier(int root, int i, const Wrench& column) {
    const int parent = link(root).parent;
    if (parent < 0) return;
    const std::string name = "c" + std::to_string(i + 1);
    Wrench at{zero_vector(), zero_vector()};
    add_wrench(list_, name, at,
               {named(list_, name + "F", column.F), named(list_, name + "N", column.N)},
               link(root).R, to_expression(origin_of(root)));
    at = {named(list_, name + "F", at.F), named(list_, name + "N", at.N)};
    const auto r = static_cast<std::size_t>(runs_.run_of[static_cast<std::size_t>(parent)]);
    if (runs_.runs[r].common_frame)
      pass_common_frame(r, parent, i, at);
    else
      pass_own_frame(parent, i, at);
  }

  void pass_own_frame(int p, int i, const Wrench& at) {
    if (link(p).type == JointType::prismatic) {
      set(p, i, at.F[2]);
      const Vector3ex slide{ex(0), ex(0), q_[static_cast<std::size_t>(link(p).coordinate)]};
      return hand_to_carrier(p, i, {at.F, at.N + cross(slide, at.F)});
    }
    set(p, i, at.N[2]);
    const CosSin& angle = angles_[static_cast<std::size_t>(p)];
    hand_to_carrier(p, i, {turn(angle, at.F), turn(angle, at.N)});
  }

  void pass_common_frame(std::size_t r, int p, int i, const Wrench& at) {
    const std::vector<RunLink>& links = composites_.run(r);
    std::size_t k = 0;
    while (links[k].link != p) ++k;
    const CosSin& angle = links[k].angle;
    const std::string name = "c" + std::to_string(i + 1);
    const Vector3ex F = named(list_, name + "F", turn(angle, at.F));
    Vector3ex N = named(list_, name + "N", turn(angle, at.N));
    const RunLink& end = links[k];
    ex moment = N[2];
    set(p, i, moment);
    for (std::size_t j = k; links[j].parent >= 0;) {
      moment = named(list_, name + "M", moment + links[j].l[0] * F[1] - links[j].l[1] * F[0]);
      j = static_cast<std::size_t>(links[j].parent);
      set(links[j].link, i, moment);
    }
    N = {N[0] + end.o[1] * F[2], N[1] - end.o[0] * F[2],
         moment + links[0].o[0] * F[1] - links[0].o[1] * F[0]};
    hand_to_carrier(links[0].link, i, {F, N});
  }

  DefinitionList& list_;
  const JointTree& tree_;
  const std::vector<ex>& q_;
  Runs runs_;
  std::vector<CosSin> angles_;
  Composites composites_;
  std::size_t n_;
  std::vector<ex> M_;
};

}  // namespace

std::vector<ex> mass_matrix(DefinitionList& list, const JointTree& tree, const DynamicsPlan& plan,
                            const std::vector<ex>& q) {
  return MassMatrixSweep(list, tree, plan, q).run();
}

}  // namespace sinew

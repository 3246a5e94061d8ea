// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/composites.h"

namespace sinew {

using GiNaC::ex;

Composites::Composites(DefinitionList& list, const JointTree& tree, const Runs& runs,
                       const std::vector<CosSin>& angles, const std::vector<ex>& q)
    : list_(list),
      tree_(tree),
      runs_(runs),
      angles_(angles),
      q_(q),
      inertias_(tree.inertias),
      before_(tree.links.size()),
      geometry_(runs.runs.size()) {
  for (std::size_t r = runs_.runs.size(); r-- > 0;) {
    if (runs_.runs[r].common_frame)
      close_common_frame(r);
    else
      close_own_frame(runs_.runs[r]);
  }
}

void Composites::close_own_frame(const Run& run) {
  const int i = run.links[0];
  const PseudoInertia& J = beyond(i);
  const std::string name = "C" + std::to_string(i + 1);
  PseudoInertia& before = before_[static_cast<std::size_t>(i)];
  if (link(i).type == JointType::prismatic) {
    const Vector3ex slide{ex(0), ex(0), q_[static_cast<std::size_t>(link(i).coordinate)]};
    before = shifted(list_, name, slide, J);
  } else {
    before = turned(list_, name, angles_[static_cast<std::size_t>(i)], J);
  }
  add_to_carrier(run, before);
}

void Composites::close_common_frame(std::size_t index) {
  const Run& run = runs_.runs[index];
  std::vector<PseudoInertia> inertias;
  for (int i : run.links) inertias.push_back(beyond(i));
  geometry_[index] = run_geometry(list_, tree_, run, angles_, inertias);
  const RunLink& root = geometry_[index][0];
  PseudoInertia whole;
  const Vector3ex o{root.o[0], root.o[1], ex(0)};
  Vector3ex moment;  // integral of r about {P}'s origin
  for (std::size_t i = 0; i < 3; ++i) {
    moment[i] = named(list_, "S_", root.S[i] + root.m * o[i]);
    whole[i][3] = whole[3][i] = moment[i];
  }
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      whole[i][j] = whole[j][i] = named(list_, "K_", root.K[i][j] + o[i] * moment[j]);
  whole[2][2] = root.zz;
  whole[3][3] = root.m;
  add_to_carrier(run, whole);
}

void Composites::add_to_carrier(const Run& run, const PseudoInertia& J) {
  const int root = run.links[0], parent = link(root).parent;
  if (parent < 0) return;
  const std::string name = "C" + std::to_string(root + 1);
  const PseudoInertia turned_J = rotated(list_, name + "r", link(root).R, J);
  PseudoInertia& carrier = inertias_[static_cast<std::size_t>(parent)];
  carrier = carrier + shifted(list_, name + "s", to_expression(run.origin), turned_J);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j)
      carrier[i][j] = carrier[j][i] = named(list_, "I" + std::to_string(parent + 1), carrier[i][j]);
}

}  // namespace sinew

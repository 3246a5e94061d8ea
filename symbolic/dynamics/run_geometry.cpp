// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/run_geometry.h"

#include <algorithm>

namespace sinew {
namespace {

using GiNaC::ex;

std::string tag(const RunLink& link) {
  return std::to_string(link.link + 1);
}

/// Origins of the run's links and their own moments, in {P}.
RunLink place(DefinitionList& list, const TreeLink& own, int index, const RunLink* parent,
              const CosSin& angle, const Run& run) {
  RunLink link;
  link.link = index;
  link.angle = angle;
  link.l = {ex(0), ex(0)};
  link.o = {to_expression(run.root_offset[0]), to_expression(run.root_offset[1])};
  if (!parent) return link;
  const Vector3ex l = turn(parent->angle, to_expression(own.p));
  for (std::size_t k = 0; k < 2; ++k) {
    link.l[k] = named(list, "l" + tag(link) + (k ? "y" : "x"), l[k]);
    link.o[k] = named(list, "o" + tag(link) + (k ? "y" : "x"), parent->o[k] + link.l[k]);
  }
  return link;
}

void start_composites(DefinitionList& list, RunLink& link, const PseudoInertia& J) {
  link.own = turned(list, "j" + tag(link), link.angle, J);
  link.m = J[3][3];
  link.zz = J[2][2];
  link.Z = J[0][0] + J[1][1];
  for (std::size_t i = 0; i < 3; ++i) link.S[i] = link.own[i][3];
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      link.K[i][j] = link.own[i][j] + (j < 2 ? link.own[i][3] * link.o[j] : ex(0));
}

void name_composites(DefinitionList& list, RunLink& link) {
  const char* axis[] = {"x", "y", "z"};
  link.S = named(list, "S" + tag(link), link.S);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      link.K[i][j] = named(list, "K" + tag(link) + axis[i] + axis[j], link.K[i][j]);
  link.m = named(list, "m" + tag(link), link.m);
  link.zz = named(list, "K" + tag(link) + "zz", link.zz);
  link.Z = named(list, "Z" + tag(link), link.Z);
}

void add_to_parent(DefinitionList& list, const RunLink& link, RunLink& parent) {
  const ex l_S = named(list, "lS" + tag(link), link.l[0] * link.S[0] + link.l[1] * link.S[1]);
  parent.Z += link.Z + 2 * l_S + link.m * (link.l[0] * link.l[0] + link.l[1] * link.l[1]);
  parent.m += link.m;
  parent.zz += link.zz;
  parent.S[2] += link.S[2];
  for (std::size_t i = 0; i < 2; ++i) {
    parent.S[i] += link.S[i] + link.m * link.l[i];
    for (std::size_t j = 0; j < 3; ++j) {
      const ex moment =
          j < 2 ? link.S[j] + link.m * link.o[j] : link.S[2];  // integral of r_j over the rest
      parent.K[i][j] += link.K[i][j] + link.l[i] * moment;
    }
  }
}

}  // namespace

std::vector<RunLink> run_geometry(DefinitionList& list, const JointTree& tree, const Run& run,
                                  const std::vector<CosSin>& angles,
                                  const std::vector<PseudoInertia>& inertias) {
  std::vector<RunLink> links;
  for (int i : run.links) {
    const TreeLink& own = tree.links[static_cast<std::size_t>(i)];
    const auto at = std::find(run.links.begin(), run.links.end(), own.parent) - run.links.begin();
    const bool root = links.empty();
    RunLink link = place(list, own, i, root ? nullptr : &links[static_cast<std::size_t>(at)],
                         angles[static_cast<std::size_t>(i)], run);
    link.parent = root ? -1 : static_cast<int>(at);
    start_composites(list, link, inertias[links.size()]);
    links.push_back(link);
  }
  for (std::size_t k = links.size(); k-- > 0;) {
    name_composites(list, links[k]);
    if (links[k].parent >= 0)
      add_to_parent(list, links[k], links[static_cast<std::size_t>(links[k].parent)]);
  }
  return links;
}

}  // namespace sinew

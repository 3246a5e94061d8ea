// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/run_motion.h"

namespace sinew {
namespace {

using GiNaC::ex;
using Pair = std::array<ex, 2>;

std::string joint_number(const RunLink& link) {
  return std::to_string(link.link + 1);
}

Pair named_pair(DefinitionList& list, const std::string& name, const Pair& value) {
  return {named(list, name + "x", value[0]), named(list, name + "y", value[1])};
}

void set_rates(DefinitionList& list, const RunLink& link, const RunLinkMotion* parent,
               const ex& w_z, const ex& qd, RunLinkMotion& motion) {
  const ex& before = parent ? parent->w : w_z;
  const Pair& arm = parent ? link.l : link.o;
  motion.w = named(list, "w" + joint_number(link) + "z", before + qd);
  motion.v = {-before * arm[1], before * arm[0]};
  if (parent) motion.v = {motion.v[0] + parent->v[0], motion.v[1] + parent->v[1]};
  motion.v = named_pair(list, "v" + joint_number(link), motion.v);
}

/// The link's own part of the sums.
void start_sums(DefinitionList& list, const RunLink& link, const InnerMotion& carried,
                RunLinkMotion& motion) {
  const InnerMotion in_P = turned(list, "E" + joint_number(link), link.angle, carried);
  const PseudoInertia& J = link.own;
  motion.G = {-motion.w * J[0][3] - in_P.p[1], -motion.w * J[1][3] + in_P.p[0]};
  motion.Y = in_P.Q[0][0] + in_P.Q[1][1];
  motion.T = {motion.w * J[1][2] - in_P.Q[2][0], -motion.w * J[0][2] - in_P.Q[2][1]};
  motion.Q_z = {in_P.Q[0][2], in_P.Q[1][2]};
  motion.p_z = in_P.p[2];
}

void name_sums(DefinitionList& list, const RunLink& link, RunLinkMotion& motion) {
  motion.G = named_pair(list, "G" + joint_number(link), motion.G);
  motion.Y = named(list, "Y" + joint_number(link), motion.Y);
  motion.T = named_pair(list, "T" + joint_number(link), motion.T);
  motion.Q_z = named_pair(list, "Qz" + joint_number(link), motion.Q_z);
  motion.p_z = named(list, "pz" + joint_number(link), motion.p_z);
}

void add_to_parent(DefinitionList& list, const RunLink& link, const RunLinkMotion& motion,
                   RunLinkMotion& parent) {
  const ex& w = parent.w;  // of the arm l
  const Pair arm_rate{-w * link.l[1], w * link.l[0]};
  for (std::size_t i = 0; i < 2; ++i) {
    parent.G[i] += motion.G[i] - link.m * w * link.l[i];
    parent.T[i] += motion.T[i] - link.S[2] * arm_rate[i];
    parent.Q_z[i] += motion.Q_z[i] + link.l[i] * motion.p_z;
  }
  const ex across =
      named(list, "X" + joint_number(link), link.l[0] * link.S[1] - link.l[1] * link.S[0]);
  parent.Y += motion.Y + link.l[0] * motion.G[1] - link.l[1] * motion.G[0] + w * across;
  parent.p_z += motion.p_z;
}

}  // namespace

std::vector<RunLinkMotion> run_motion(DefinitionList& list, const std::vector<RunLink>& links,
                                      const std::vector<InnerMotion>& carried, const ex& w_z,
                                      const std::vector<ex>& qd) {
  std::vector<RunLinkMotion> motions(links.size());
  for (std::size_t k = 0; k < links.size(); ++k) {
    const int parent = links[k].parent;
    set_rates(list, links[k], parent < 0 ? nullptr : &motions[static_cast<std::size_t>(parent)],
              w_z, qd[k], motions[k]);
    start_sums(list, links[k], carried[k], motions[k]);
  }
  for (std::size_t k = links.size(); k-- > 0;) {
    name_sums(list, links[k], motions[k]);
    if (links[k].parent >= 0)
      add_to_parent(list, links[k], motions[k], motions[static_cast<std::size_t>(links[k].parent)]);
  }
  return motions;
}

InnerMotion whole_motion(DefinitionList& list, const std::vector<RunLink>& links,
                         const std::vector<InnerMotion>& carried, const std::vector<ex>& qd) {
  InnerMotion whole;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const RunLink& link = links[k];
    const Vector3ex o{link.o[0], link.o[1], ex(0)};
    whole = whole + shifted(list, "E" + joint_number(link) + "s", o,
                            turned(list, "E" + joint_number(link), link.angle, carried[k]));
    // joint k turns all beyond it: dr = qd (-(y - o_y), x - o_x, 0)
    for (std::size_t i = 0; i < 3; ++i) {
      whole.Q[i][0] += -qd[k] * link.K[1][i];
      whole.Q[i][1] += qd[k] * link.K[0][i];
    }
    whole.p[0] += -qd[k] * link.S[1];
    whole.p[1] += qd[k] * link.S[0];
  }
  const std::string name = "E" + joint_number(links[0]) + "w";
  for (std::size_t i = 0; i < 3; ++i) whole.Q[i] = named(list, name + "Q" + "xyz"[i], whole.Q[i]);
  whole.p = named(list, name + "p", whole.p);
  return whole;
}

}  // namespace sinew

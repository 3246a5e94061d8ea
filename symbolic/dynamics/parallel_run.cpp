// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/parallel_run.h"

namespace sinew {
namespace {

using GiNaC::ex;
using Pair = std::array<ex, 2>;

}  // namespace

ParallelRun::ParallelRun(DefinitionList& list, const JointTree& tree, std::vector<RunLink> geometry,
                         bool pair_by_pair, Motion base, const std::vector<ex>& qd,
                         const std::vector<ex>& qdd)
    : list_(list),
      tree_(tree),
      links_(std::move(geometry)),
      pair_by_pair_(pair_by_pair),
      base_(std::move(base)) {
  set_rates(qd, qdd);
}

std::string ParallelRun::tag(int index) const {
  return std::to_string(links_[static_cast<std::size_t>(index)].link + 1);
}

ex ParallelRun::J(int index, int row, int col) const {
  const RunLink& link = links_[static_cast<std::size_t>(index)];
  return tree_.inertias[static_cast<std::size_t>(link.link)][static_cast<std::size_t>(row)]
                       [static_cast<std::size_t>(col)];
}

/// Second derivative of a vector fixed in the link, given by its constant components.
Pair ParallelRun::second_derivative(int index, const ex& x, const ex& y) const {
  const Rates& r = rates_[static_cast<std::size_t>(index)];
  return {-x * r.e[0] - y * r.e[1], x * r.e[1] - y * r.e[0]};
}

Pair ParallelRun::root_acceleration() const {
  const Pair& o = links_[0].o;
  const ex& w = base_.w[2];
  const ex square = o[0].is_zero() && o[1].is_zero() ? ex(0) : named(list_, "w_zz", w * w);
  return {named(list_, "a_x", base_.a[0] - square * o[0] - base_.alpha[2] * o[1]),
          named(list_, "a_y", base_.a[1] - square * o[1] + base_.alpha[2] * o[0])};
}

RunLink ParallelRun::whole_about_origin() const {
  RunLink whole = links_[0];
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j)
      whole.K[i][j] = named(list_, "K_" + std::to_string(i) + std::to_string(j),
                            links_[0].K[i][j] + links_[0].o[i] * links_[0].S[j]);
  return whole;
}

void ParallelRun::set_rates(const std::vector<ex>& qd, const std::vector<ex>& qdd) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const RunLink& link = links_[k];
    const TreeLink& own = tree_.links[static_cast<std::size_t>(link.link)];
    const std::string index = tag(static_cast<int>(k));
    const auto coordinate = static_cast<std::size_t>(own.coordinate);
    const bool root = link.parent < 0;
    Rates r;
    const ex before_w = root ? base_.w[2] : rates_[static_cast<std::size_t>(link.parent)].w;
    const ex before_alpha =
        root ? base_.alpha[2] : rates_[static_cast<std::size_t>(link.parent)].alpha;
    r.w = named(list_, "w" + index + "z", before_w + own.sign * qd[coordinate]);
    r.alpha = named(list_, "al" + index + "z", before_alpha + own.sign * qdd[coordinate]);
    r.rate = own.sign * qd[coordinate];
    const ex square = named(list_, "w" + index + "zz", r.w * r.w);
    r.e = {named(list_, "e" + index + "x", r.alpha * link.angle.s + square * link.angle.c),
           named(list_, "e" + index + "y", r.alpha * link.angle.c - square * link.angle.s)};
    r.a = root ? root_acceleration() : Pair{ex(0), ex(0)};
    rates_.push_back(r);
    if (root) continue;
    const Pair l = second_derivative(link.parent, to_expression(own.p(0)), to_expression(own.p(1)));
    const Rates& parent = rates_[static_cast<std::size_t>(link.parent)];
    for (std::size_t i = 0; i < 2; ++i)
      rates_[k].a[i] = named(list_, "a" + index + (i ? "y" : "x"), parent.a[i] + l[i]);
  }
}

Motion ParallelRun::link_motion(int index) const {
  const RunLink& link = links_[static_cast<std::size_t>(index)];
  const Rates& r = rates_[static_cast<std::size_t>(index)];
  const std::string name = tag(index);
  const ex &wx = base_.w[0], &wy = base_.w[1];
  Motion before;
  before.w = {wx, wy, ex(0)};
  before.alpha = {ex(0), ex(0), ex(0)};
  before.U = zero_matrix();
  for (std::size_t i = 0; i < 3; ++i) before.U[i][2] = base_.U[i][2];
  const ex xy = named(list_, "w_xy", wx * wy);
  const ex& wz = base_.w[2];
  Pair velocity{-wz * links_[0].o[1],
                wz * links_[0].o[0]};  // of the origin, by the links before it
  for (int k = index; links_[static_cast<std::size_t>(k)].parent >= 0;) {
    const RunLink& at = links_[static_cast<std::size_t>(k)];
    const ex& w = rates_[static_cast<std::size_t>(at.parent)].w;
    velocity[0] -= w * at.l[1];
    velocity[1] += w * at.l[0];
    k = at.parent;
  }
  const ex vx = named(list_, "v" + name + "x", velocity[0]),
           vy = named(list_, "v" + name + "y", velocity[1]);
  const ex &X = link.o[0], &Y = link.o[1];
  before.a = named(
      list_, "b" + name,
      Vector3ex{r.a[0] + xy * Y - wy * wy * X, r.a[1] + xy * X - wx * wx * Y,
                base_.a[2] - base_.U[0][2] * X - base_.U[1][2] * Y + 2 * (wx * vy - wy * vx)});
  return turned_motion(list_, name, before, link.angle, r.w, r.alpha);
}

ParallelRun::Planar ParallelRun::planar_dynamics(const std::vector<Wrench>& external) const {
  std::vector<Pair> force;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const int index = static_cast<int>(k);
    const Pair own = second_derivative(index, J(index, 0, 3), J(index, 1, 3));
    force.push_back({own[0] + external[k].F[0], own[1] + external[k].F[1]});
  }
  for (std::size_t k = links_.size(); k-- > 0;) {
    for (std::size_t i = 0; i < 2; ++i)
      force[k][i] = named(list_, "F" + tag(static_cast<int>(k)) + (i ? "y" : "x"), force[k][i]);
    if (links_[k].parent < 0) continue;
    const auto parent = static_cast<std::size_t>(links_[k].parent);
    for (std::size_t i = 0; i < 2; ++i) force[parent][i] += force[k][i];
  }
  return {pair_by_pair_ ? pair_torques(external) : chained_torques(force, external), force[0]};
}

std::vector<ex> ParallelRun::chained_torques(const std::vector<Pair>& force,
                                             const std::vector<Wrench>& external) const {
  std::vector<ex> torque(links_.size());
  for (std::size_t k = links_.size(); k-- > 0;) {
    const RunLink& link = links_[k];
    const Rates& r = rates_[k];
    torque[k] += own_inertia(k) * r.alpha + link.own[0][3] * r.a[1] - link.own[1][3] * r.a[0] +
                 external[k].N[2];
    torque[k] = named(list_, "n" + tag(static_cast<int>(k)), torque[k]);
    if (link.parent >= 0)
      torque[static_cast<std::size_t>(link.parent)] +=
          torque[k] + link.l[0] * force[k][1] - link.l[1] * force[k][0];
  }
  return torque;
}

std::vector<ex> ParallelRun::pair_torques(const std::vector<Wrench>& external) const {
  std::vector<ex> torque(links_.size());
  const Pair& a = rates_[0].a;
  for (std::size_t j = 0; j < links_.size(); ++j) {
    const Pair s{links_[j].own[0][3], links_[j].own[1][3]};
    const Rates& at_j = rates_[j];
    torque[j] += own_inertia(j) * at_j.alpha + s[0] * a[1] - s[1] * a[0] + external[j].N[2];
    for (std::size_t child = j; links_[child].parent >= 0;) {
      const Pair& l = links_[child].l;
      const auto i = static_cast<std::size_t>(links_[child].parent);
      const std::string name = tag(static_cast<int>(i)) + "_" + tag(static_cast<int>(j));
      const Rates& at_i = rates_[i];
      const ex across = named(list_, "X" + name, l[0] * s[1] - l[1] * s[0]);
      const bool accelerated = !at_i.alpha.is_zero() || !at_j.alpha.is_zero();
      const ex along = accelerated ? named(list_, "D" + name, l[0] * s[0] + l[1] * s[1]) : ex(0);
      torque[i] += at_j.alpha * along - square(j) * across + l[0] * external[j].F[1] -
                   l[1] * external[j].F[0];
      torque[j] += at_i.alpha * along + square(i) * across;
      child = i;
    }
  }
  for (std::size_t k = links_.size(); k-- > 0;) {
    torque[k] = named(list_, "n" + tag(static_cast<int>(k)), torque[k]);
    if (links_[k].parent >= 0) torque[static_cast<std::size_t>(links_[k].parent)] += torque[k];
  }
  return torque;
}

ex ParallelRun::own_inertia(std::size_t k) const {
  const PseudoInertia& J = tree_.inertias[static_cast<std::size_t>(links_[k].link)];
  return named(list_, "Z" + tag(static_cast<int>(k)), J[0][0] + J[1][1]);
}

ex ParallelRun::square(std::size_t k) const {
  return named(list_, "w" + tag(static_cast<int>(k)) + "zz", rates_[k].w * rates_[k].w);
}

/// What U' contributes about link k's axis: integral of (r - o_k) x (U' r), z component.
ex ParallelRun::carrier_torque(int index) const {
  const auto& K = links_[static_cast<std::size_t>(index)].K;
  const ex &wx = base_.w[0], &wy = base_.w[1];
  const ex xx = named(list_, "w_xx", wx * wx), yy = named(list_, "w_yy", wy * wy),
           xy = named(list_, "w_xy", wx * wy);
  const ex spread = xy.is_zero() ? ex(0) : named(list_, "K" + tag(index) + "d", K[0][0] - K[1][1]);
  return xy * spread - xx * K[0][1] + yy * K[1][0] + base_.U[1][2] * K[0][2] -
         base_.U[0][2] * K[1][2];
}

Wrench ParallelRun::carrier_wrench(const Planar& planar) const {
  const ex &wx = base_.w[0], &wy = base_.w[1];
  const ex &Uxz = base_.U[0][2], &Uyz = base_.U[1][2];
  const ex xx = named(list_, "w_xx", wx * wx), yy = named(list_, "w_yy", wy * wy),
           xy = named(list_, "w_xy", wx * wy);
  const RunLink whole = whole_about_origin();
  const auto& K = whole.K;
  const auto& S = whole.S;
  const bool on_axis = links_[0].o[0].is_zero() && links_[0].o[1].is_zero();
  ex rate_Sx = 0, rate_Sy = 0, rate_x = 0, rate_y = 0, rate_xx = 0, rate_yy = 0;
  Pair g{ex(0), ex(0)};
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const ex rate = k == 0 && on_axis ? rates_[k].w : rates_[k].rate;
    rate_Sx += rate * links_[k].S[0];
    rate_Sy += rate * links_[k].S[1];
    rate_x += rate * links_[k].K[0][1];
    rate_y += rate * links_[k].K[1][0];
    rate_xx += rate * links_[k].K[0][0];
    rate_yy += rate * links_[k].K[1][1];
    const Pair own = second_derivative(static_cast<int>(k), J(static_cast<int>(k), 0, 2),
                                       J(static_cast<int>(k), 1, 2));
    g = {g[0] + own[0], g[1] + own[1]};
  }
  if (!on_axis) {  // the carrier turns the whole run about {P}'s origin, not about the first axis
    const ex& rate = base_.w[2];
    rate_Sx += rate * S[0];
    rate_Sy += rate * S[1];
    rate_x += rate * K[0][1];
    rate_y += rate * K[1][0];
    rate_xx += rate * K[0][0];
    rate_yy += rate * K[1][1];
  }
  const std::string name = tag(0);
  const ex twice_x = named(list_, "w_2x", 2 * wx), twice_y = named(list_, "w_2y", 2 * wy);
  rate_Sx = named(list_, "R" + name + "x", rate_Sx);
  rate_Sy = named(list_, "R" + name + "y", rate_Sy);
  rate_x = named(list_, "R" + name + "xy", rate_x);
  rate_y = named(list_, "R" + name + "yx", rate_y);
  rate_xx = named(list_, "R" + name + "xx", rate_xx);
  rate_yy = named(list_, "R" + name + "yy", rate_yy);
  Wrench w;
  w.F = {planar.force[0] + xy * S[1] - yy * S[0], planar.force[1] + xy * S[0] - xx * S[1],
         twice_x * rate_Sx + twice_y * rate_Sy - Uxz * S[0] - Uyz * S[1]};
  for (std::size_t i = 0; i < 2; ++i) w.F[i] = named(list_, "F_" + name + (i ? "y" : "x"), w.F[i]);
  w.N = {twice_x * rate_x + twice_y * rate_yy - g[1] + S[1] * base_.a[2] - Uxz * K[1][0] -
             Uyz * K[1][1] - yy * K[1][2] - xy * K[0][2],
         g[0] - twice_x * rate_xx - twice_y * rate_y - S[0] * base_.a[2] + Uxz * K[0][0] +
             Uyz * K[0][1] + xx * K[0][2] + xy * K[1][2],
         ex(0)};
  return w;
}

Wrench ParallelRun::close(const std::vector<Wrench>& external, std::vector<ex>& tau) const {
  std::vector<Wrench> in_P;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const std::string name = "P" + tag(static_cast<int>(k));
    in_P.push_back({named(list_, "F" + name, turn(links_[k].angle, external[k].F)),
                    named(list_, "N" + name, turn(links_[k].angle, external[k].N))});
  }
  const Planar planar = planar_dynamics(in_P);
  Wrench wrench = carrier_wrench(planar);
  for (std::size_t k = 0; k < links_.size(); ++k) {
    const TreeLink& own = tree_.links[static_cast<std::size_t>(links_[k].link)];
    const ex torque = named(list_, "t" + tag(static_cast<int>(k)),
                            planar.torque[k] + carrier_torque(static_cast<int>(k)));
    if (k == 0) wrench.N[2] = torque + links_[0].o[0] * wrench.F[1] - links_[0].o[1] * wrench.F[0];
    tau[static_cast<std::size_t>(own.coordinate)] = own.sign * torque;
    wrench.F[2] += in_P[k].F[2];
    wrench.N[0] += in_P[k].N[0] + links_[k].o[1] * in_P[k].F[2];
    wrench.N[1] += in_P[k].N[1] - links_[k].o[0] * in_P[k].F[2];
  }
  return wrench;
}

}  // namespace sinew

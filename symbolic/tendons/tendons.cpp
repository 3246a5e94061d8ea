// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/tendons.h"

#include <Eigen/LU>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/dynamics/kinematics.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/exact_number.h"

namespace sinew {
namespace {

using GiNaC::ex;

std::size_t coordinate_named(const Mechanism& mechanism, const std::string& joint) {
  const std::vector<int> coordinates = coordinate_of_joint(mechanism);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i)
    if (mechanism.joints[i].name == joint) return static_cast<std::size_t>(coordinates[i]);
  throw std::invalid_argument("no joint is called " + joint);
}

ex straight_length(DefinitionList& list, const std::string& name, const Vector3ex& from,
                   const Vector3ex& to) {
  Vector3ex d;
  for (std::size_t k = 0; k < 3; ++k) d[k] = to[k] - from[k];
  d = named(list, name + "d", d);
  return list.define(name, sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
}

}  // namespace

int body_named(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i)
    if (mechanism.bodies[i].name == name) return static_cast<int>(i);
  if (name == "base") return -1;
  throw std::invalid_argument("no body is called " + name);
}

std::vector<ex> tendon_lengths(DefinitionList& list, const Mechanism& mechanism,
                               const JointTree& tree, const std::vector<GiNaC::symbol>& q) {
  const std::vector<ex> joints = Coordinates(mechanism).at(list, {q.begin(), q.end()}).positions();
  Kinematics kinematics(list, tree, joints);
  std::vector<ex> lengths;
  for (const Tendon& tendon : mechanism.tendons) {
    ex h = exact_number(tendon.h0);
    for (const PulleyRouting& pulley : tendon.pulleys)
      h += exact_number(pulley.radius) * joints[coordinate_named(mechanism, pulley.joint)];
    for (const StraightRouting& straight : tendon.straights) {
      const std::string name = tendon.name + "_length";
      h += straight_length(
          list, name,
          kinematics.point(name + "_from", body_named(mechanism, straight.from_body),
                           straight.from),
          kinematics.point(name + "_to", body_named(mechanism, straight.to_body), straight.to));
    }
    lengths.push_back(h);
  }
  return lengths;
}

std::vector<ex> coupling_matrix(DefinitionList& list, const std::vector<ex>& lengths,
                                const std::vector<GiNaC::symbol>& q) {
  std::vector<ex> P = jacobian(list, lengths, q);
  for (std::size_t k = 0; k < P.size(); ++k)
    P[k] =
        named(list, "P" + std::to_string(k / q.size() + 1) + "_" + std::to_string(k % q.size() + 1),
              P[k]);
  return P;
}

std::vector<ex> joint_torque(DefinitionList& list, const std::vector<ex>& P,
                             const std::vector<GiNaC::symbol>& f, std::size_t n) {
  (void)list;
  std::vector<ex> tau(n, ex(0));
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = 0; j < n; ++j) tau[j] -= P[i * n + j] * f[i];
  return tau;
}

std::vector<ex> joint_stiffness(DefinitionList& list, const std::vector<ex>& lengths,
                                const std::vector<ex>& P, const std::vector<GiNaC::symbol>& q,
                                const std::vector<GiNaC::symbol>& f,
                                const std::vector<GiNaC::symbol>& kt) {
  const std::size_t n = q.size();
  std::vector<ex> K(n * n, ex(0));
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const std::vector<ex> H = hessian(list, lengths[i], q);
    for (std::size_t r = 0; r < n; ++r) {
      if (P[i * n + r].is_zero()) continue;
      const ex weighted = named(list, "w" + std::to_string(i + 1) + "_" + std::to_string(r + 1),
                                kt[i] * P[i * n + r]);
      for (std::size_t c = r; c < n; ++c) K[r * n + c] += weighted * P[i * n + c];
    }
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = r; c < n; ++c) K[r * n + c] += f[i] * H[r * n + c];
  }
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = r; c < n; ++c)
      K[c * n + r] = K[r * n + c] =
          named(list, "K" + std::to_string(r + 1) + "_" + std::to_string(c + 1), K[r * n + c]);
  return K;
}

namespace {

/// At coordinates zero, where a joint that follows another one may not be at zero.
ex length_at_zero(const Mechanism& mechanism, const Tendon& tendon) {
  ex length = exact_number(tendon.h0);
  for (const PulleyRouting& pulley : tendon.pulleys)
    for (const JointCoupling& coupling : mechanism.couplings)
      if (coupling.dependent == pulley.joint)
        length += exact_number(pulley.radius) * exact_number(coupling.offset);
  return length;
}

}  // namespace

std::optional<std::vector<ex>> link_position(const Mechanism& mechanism, const std::vector<ex>& P,
                                             const std::vector<GiNaC::symbol>& h) {
  const auto m = static_cast<Eigen::Index>(h.size());
  const Eigen::Index n = static_cast<Eigen::Index>(P.size()) / m;
  Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> constant(m, n);
  for (Eigen::Index i = 0; i < m; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const ex& entry = P[static_cast<std::size_t>(i * n + j)];
      if (!GiNaC::is_a<GiNaC::numeric>(entry)) return std::nullopt;
      constant(i, j) = Number(GiNaC::ex_to<GiNaC::numeric>(entry).to_double());
    }
  const Eigen::FullPivLU<Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>> normal(
      constant.transpose() * constant);
  if (normal.rank() < n) return std::nullopt;
  const Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> inverse =
      normal.solve(constant.transpose());
  std::vector<ex> q(static_cast<std::size_t>(n), ex(0));
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < m; ++i) {
      Number weight = inverse(j, i);
      if (abs(weight) < Number("1e-30") * inverse.cwiseAbs().maxCoeff()) continue;
      const ex displacement =
          h[static_cast<std::size_t>(i)] -
          length_at_zero(mechanism, mechanism.tendons[static_cast<std::size_t>(i)]);
      q[static_cast<std::size_t>(j)] += to_expression(weight) * displacement;
    }
  return q;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/tendon_functions.h"

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/differentiate.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/tendons/nonlinear_position.h"
#include "symbolic/tendons/straight_base.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/tendons/tendons.h"

namespace sinew {
namespace {

using GiNaC::ex;

/// Lengths over the joint ranges: the range in which link positions are asked for.
Argument length_argument(const Mechanism& mechanism, const Function& lengths) {
  Argument h = make_argument("h", static_cast<int>(mechanism.tendons.size()), 1, "m",
                             "tendon path lengths", {0, 0});
  for (std::size_t i = 0; i < mechanism.tendons.size(); ++i) {
    double reach = 0;
    for (const PulleyRouting& pulley : mechanism.tendons[i].pulleys)
      for (const Joint& joint : mechanism.joints)
        if (joint.name == pulley.joint)
          reach += std::abs(pulley.radius) * std::max(std::abs(joint.low), std::abs(joint.high));
    h.ranges[i] = {mechanism.tendons[i].h0 - reach, mechanism.tendons[i].h0 + reach};
  }
  h.reference = rounded_values(lengths, lengths.inputs[0].reference);
  return h;
}

/// H of every tendon, one row a tendon.
Function tendon_hessian(const Mechanism& mechanism, const Argument& q, DefinitionList list,
                        const std::vector<ex>& lengths) {
  std::vector<ex> H;
  for (const ex& length : lengths) {
    const std::vector<ex> own = hessian(list, length, q.symbols);
    H.insert(H.end(), own.begin(), own.end());
  }
  return {"tendon_hessian",
          "Second derivatives of the path lengths.",
          "",
          {q},
          list.items(),
          {{"H", static_cast<int>(mechanism.tendons.size()), q.rows * q.rows, H,
            "m/" + q.unit + "^2", "each row a symmetric matrix, row-major"}}};
}

/// sigma^2 (P^T P)^-1 for constant P of full column rank.
Function covariance(const std::vector<ex>& P, const Argument& q) {
  const auto n = static_cast<unsigned>(q.rows);
  GiNaC::matrix normal(n, n);
  for (std::size_t i = 0; i < P.size() / n; ++i)
    for (unsigned r = 0; r < n; ++r)
      for (unsigned c = 0; c < n; ++c) normal(r, c) += P[i * n + r] * P[i * n + c];
  const GiNaC::matrix inverse = normal.inverse();
  const Argument sigma =
      scalar_argument("sigma", "m", {0.0, 0.002}, "standard deviation of a length");
  DefinitionList list;
  const ex variance = list.define("variance", sigma.symbols[0] * sigma.symbols[0]);
  std::vector<ex> values;
  for (unsigned k = 0; k < n * n; ++k) values.push_back(variance * inverse(k / n, k % n));
  return {"link_position_covariance",
          "Covariance of link_position for independent errors of the lengths: sigma^2 (P^T P)^-1.",
          "",
          {sigma},
          list.items(),
          {{"covariance", q.rows, q.rows, values, q.unit + "^2", "symmetric"}}};
}

/// Joint positions from tendon lengths, by whichever way the mechanism allows.
std::vector<Function> position_functions(const Mechanism& mechanism, const Function& lengths,
                                         const std::vector<ex>& P, const Argument& q) {
  const Argument h = length_argument(mechanism, lengths);
  if (const auto position = link_position(mechanism, P, h.symbols))
    return {{"link_position",
             "Joint positions from tendon lengths by least squares: P^+ (h - h(0)).",
             "(5.13)",
             {h},
             {},
             {{"q", q.rows, 1, *position, q.unit, "joint positions"}}},
            covariance(P, q)};
  if (const auto base = straight_base(mechanism)) return straight_base_functions(mechanism, *base);
  return nonlinear_position_functions(mechanism);
}

}  // namespace

std::vector<Function> tendon_functions(const Mechanism& mechanism) {
  if (mechanism.tendons.empty()) return {};
  const int m = static_cast<int>(mechanism.tendons.size());
  const Argument q = joint_positions(mechanism);
  const Argument f =
      make_argument("f", m, 1, "N", "tendon forces, pulling", {0, mechanism.tendon_force_high});
  const Argument kt =
      make_argument("kt", m, 1, "N/m", "tendon stiffnesses",
                    {mechanism.tendon_stiffness_low, mechanism.tendon_stiffness_high});
  const int n = q.rows;
  DefinitionList list;
  const JointTree tree = build_joint_tree(mechanism);
  const std::vector<ex> lengths = tendon_lengths(list, mechanism, tree, q.symbols);
  const std::vector<Definition> for_lengths = list.items();
  const std::vector<ex> P = coupling_matrix(list, lengths, q.symbols);
  const std::vector<Definition> for_coupling = list.items();
  const std::vector<ex> tau = joint_torque(list, P, f.symbols, static_cast<std::size_t>(n));
  std::vector<Function> result;
  result.push_back({"tendon_lengths",
                    "Path lengths of the tendons.",
                    "(5.5)",
                    {q},
                    for_lengths,
                    {{"h", m, 1, lengths, "m", "tendon path lengths"}}});
  result.push_back({"coupling_matrix",
                    "Coupling matrix P = dh/dq.",
                    "(5.9)",
                    {q},
                    for_coupling,
                    {{"P", m, n, P, "m/" + q.unit, "coupling matrix"}}});
  result.push_back({"joint_torque",
                    "Joint torques from tendon forces: tau = -P^T f.",
                    "(5.8)",
                    {q, f},
                    for_coupling,
                    {{"tau", n, 1, tau, torque_unit(mechanism), "joint torques"}}});
  const DefinitionList for_hessian = list;
  const std::vector<ex> K = joint_stiffness(list, lengths, P, q.symbols, f.symbols, kt.symbols);
  result.push_back(
      {"joint_stiffness",
       "Joint stiffness with the motors held: sum f_i d2h_i/dq2 + P^T diag(kt) P.",
       "(5.12)",
       {q, f, kt},
       list.items(),
       {{"K", n, n, K, torque_unit(mechanism) + "/" + q.unit, "stiffness matrix, symmetric"}}});
  result.push_back(tendon_hessian(mechanism, q, for_hessian, lengths));
  for (const Function& function : position_functions(mechanism, result[0], P, q))
    result.push_back(function);
  return result;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// The Coriolis matrix as it is derived against its definition, derivatives of the mass matrix: the
// same function in every form that a plan can ask for, and shorter by an order.
#include <catch2/catch.hpp>

#include "generator/cost.h"
#include "generator/evaluate.h"
#include "generator/lower.h"
#include "generator/passes/pipeline.h"
#include "symbolic/dynamics/coriolis.h"
#include "symbolic/dynamics/mass_matrix.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/expressions/differentiate.h"
#include "tests/reference/random_mechanism.h"
#include "tests/reference/reference_model.h"

namespace sinew::reference {
namespace {

using GiNaC::ex;

std::vector<ex> expressions(const Argument& argument) {
  return {argument.symbols.begin(), argument.symbols.end()};
}

/// C_ij = 1/2 sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) qd_k, literally.
std::vector<ex> by_definition(DefinitionList& list, const std::vector<ex>& M, const Argument& q,
                              const Argument& qd) {
  const std::size_t n = q.symbols.size();
  const std::vector<ex> slopes = jacobian(list, M, q.symbols);
  const auto slope = [&](std::size_t i, std::size_t j, std::size_t k) {
    return slopes[(i * n + j) * n + k];
  };
  std::vector<ex> C(n * n, ex(0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k)
        C[i * n + j] +=
            list.define("G", slope(i, j, k) + slope(i, k, j) - slope(j, k, i)) * qd.symbols[k] / 2;
  return C;
}

enum class Form { derived, definition };

Graph coriolis_graph(const Mechanism& mechanism, const DynamicsPlan& plan, Form form) {
  const JointTree tree = build_joint_tree(mechanism, frames_of(plan));
  const Argument q = joint_positions(mechanism), qd = joint_velocities(mechanism);
  DefinitionList list;
  const std::vector<ex> C =
      form == Form::derived
          ? coriolis_matrix(list, tree, plan, expressions(q), expressions(qd)).C
          : by_definition(list, mass_matrix(list, tree, plan, expressions(q)), q, qd);
  return lower(
      {"coriolis_matrix", "", "", {q, qd}, list.items(), {{"C", q.rows, q.rows, C, "", ""}}});
}

DynamicsPlan plan_of(const Mechanism& mechanism, const JointPlan& each) {
  return DynamicsPlan(build_joint_tree(mechanism).links.size(), each);
}

std::vector<JointPlan> plans() {
  JointPlan apart, lone, at_carrier, outgoing;
  apart.join_run = false;
  lone.lone_run = true;
  at_carrier.lone_run = at_carrier.keep_carrier_origin = true;
  outgoing.frame.origin = OriginChoice::outgoing;
  return {JointPlan{}, apart, lone, at_carrier, outgoing};
}

std::vector<Exact> values_of(const Graph& graph, const State& state) {
  std::vector<Exact> inputs;
  for (const Eigen::VectorXd* part : {&state.q, &state.qd})
    for (Eigen::Index i = 0; i < part->size(); ++i) inputs.emplace_back((*part)[i]);
  return evaluate<Exact>(graph, inputs);
}

/// Largest difference over the largest entry.
Exact difference(const std::vector<Exact>& x, const std::vector<Exact>& y) {
  Exact worst = 0, scale = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    worst = std::max(worst, Exact(abs(x[i] - y[i])));
    scale = std::max(scale, Exact(abs(y[i])));
  }
  return worst / scale;
}

std::vector<Exact> transposed(const std::vector<Exact>& matrix, std::size_t n) {
  std::vector<Exact> result;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) result.push_back(matrix[j * n + i]);
  return result;
}

int operations(const Graph& graph) {
  return count_operations(optimise(graph, {"schedule"})).operations();
}

/// Frames' rotation matrices are rounded to double before either form is derived, and what is no
/// exact rotation turns a cross product and its factors a little differently: by how far R^T R is
/// from the identity and the axis from a unit vector, at every joint on the way.
Exact rounding_of_frames(const Mechanism& mechanism) {
  Exact sum = 0;
  for (const Joint& joint : mechanism.joints) {
    const auto& R = joint.origin.rotation;
    Exact worst = 0;
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3; ++j) {
        Exact product = i == j ? -1 : 0;
        for (Eigen::Index k = 0; k < 3; ++k) product += Exact(R(k, i)) * Exact(R(k, j));
        worst = std::max(worst, Exact(abs(product)));
      }
    Exact length = -1;
    for (Eigen::Index k = 0; k < 3; ++k) length += Exact(joint.axis(k)) * Exact(joint.axis(k));
    sum += worst + abs(length);
  }
  return sum;
}

TEST_CASE("the Coriolis matrix is Christoffel's in every form") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Mechanism mechanism =
        random_mechanism(400 + seed, {.joints = 5, .branched = seed % 2 == 0, .arm = seed > 3});
    const State state = sample_states(mechanism, 8, seed).back();
    const Exact rounded = rounding_of_frames(mechanism);
    for (const JointPlan& each : plans()) {
      const DynamicsPlan plan = plan_of(mechanism, each);
      const auto derived = values_of(coriolis_graph(mechanism, plan, Form::derived), state);
      const auto exact = values_of(coriolis_graph(mechanism, plan, Form::definition), state);
      INFO("seed " << seed << ", frames rounded by " << rounded.convert_to<double>());
      // Two factors on two sides, and constants that are rounded once.
      CHECK(difference(derived, exact) <= 4 * rounded + ldexp(Exact(1), -53));
      // planted: the transpose has the same symmetric part, dM/dt / 2
      const auto n = static_cast<std::size_t>(state.q.size());
      CHECK(difference(transposed(derived, n), exact) > Exact("1e-6"));
    }
  }
}

TEST_CASE("the Coriolis matrix grows with the square of a chain's length") {
  const auto at = [](int joints, Form form) {
    const Mechanism chain = random_mechanism(
        500, {.joints = joints, .prismatic = 0.0, .fixed = 0.0, .branched = false, .arm = true});
    return operations(coriolis_graph(chain, {}, form));
  };
  const auto growth = [&](int joints, Form form) {
    return static_cast<double>(at(2 * joints, form)) / at(joints, form);
  };
  CHECK(growth(10, Form::derived) < 4.5);
  CHECK(growth(5, Form::definition) > 6.0);  // planted: the derivatives of the mass matrix
}

}  // namespace
}  // namespace sinew::reference

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "tests/symbolic/dynamics/emitted_functions.h"
#include "tests/symbolic/dynamics/mechanics_checks.h"

namespace sinew::reference {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kStep = 0.004;

double largest(const MatrixXd& values) {
  return values.allFinite() ? values.cwiseAbs().maxCoeff()
                            : std::numeric_limits<double>::infinity();
}

/// Worst over states of what `violation` returns; NaN counts as infinite.
template <class Violation>
double worst_of(const std::vector<State>& states, const Violation& violation) {
  double worst = 0.0;
  for (const State& at : states) {
    const double next = violation(at);
    worst = next <= worst ? worst : next;
  }
  return worst;
}

/// Columns: derivative by each joint in turn.
template <class Function>
MatrixXd derivative_by_joints(const Function& value, const VectorXd& q) {
  MatrixXd columns;
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const MatrixXd column = derivative_at_zero(
        [&](double t) { return value(q + t * VectorXd::Unit(q.size(), k)); }, kStep);
    if (k == 0) columns.resize(column.rows(), q.size());
    columns.col(k) = column;
  }
  return columns;
}

double coupling_mismatch(const EmittedFunctions& model, const State& at) {
  const MatrixXd coupling = model("coupling_matrix", {at.q});
  const MatrixXd slope =
      derivative_by_joints([&](const VectorXd& q) { return model("tendon_lengths", {q}); }, at.q);
  return largest(coupling - slope) / largest(coupling);
}

/// Power of the joint torques plus power of the tendons: tau . qd + f . hdot = 0.
double virtual_work(const EmittedFunctions& model, const State& at) {
  const VectorXd tau = model("joint_torque", {at.q, at.f});
  const MatrixXd coupling = model("coupling_matrix", {at.q});
  const VectorXd rate = coupling * at.qd;
  const double size = at.f.cwiseAbs().dot(coupling.cwiseAbs() * at.qd.cwiseAbs());
  const double sum = tau.dot(at.qd) + at.f.dot(rate);
  return size > 0.0 ? std::abs(sum) / size : std::abs(sum);
}

double stiffness_asymmetry(const EmittedFunctions& model, const State& at) {
  const MatrixXd stiffness = model("joint_stiffness", {at.q, at.f, at.kt});
  return largest(stiffness - stiffness.transpose()) / largest(stiffness);
}

/// K against -dtau/dq of tendons that pull with f + kt (h - h(q)).
double stiffness_mismatch(const EmittedFunctions& model, const State& at) {
  const VectorXd rest = model("tendon_lengths", {at.q});
  const MatrixXd slope = derivative_by_joints(
      [&](const VectorXd& q) {
        const VectorXd stretch = model("tendon_lengths", {q}) - rest;
        const VectorXd force = at.f + at.kt.cwiseProduct(stretch);
        return model("joint_torque", {q, force});
      },
      at.q);
  const MatrixXd stiffness = model("joint_stiffness", {at.q, at.f, at.kt});
  return largest(stiffness + slope) / largest(stiffness);
}

double position_error(const EmittedFunctions& model, const State& at) {
  const VectorXd lengths = model("tendon_lengths", {at.q});
  return largest(model("link_position", {lengths}) - at.q);
}

}  // namespace

std::vector<LawCheck> tendon_laws(const EmittedModel& emitted, const std::vector<State>& states) {
  const EmittedFunctions model(emitted);
  const auto worst = [&](double (*violation)(const EmittedFunctions&, const State&)) {
    return worst_of(states, [&](const State& at) { return violation(model, at); });
  };
  std::vector<LawCheck> checks = {
      {"P is the derivative of the lengths", worst(coupling_mismatch), 1e-10},
      {"torques do the tendons' work", worst(virtual_work), 1e-14},
      {"K is symmetric", worst(stiffness_asymmetry), 0.0},
      {"K is -dtau/dq of elastic tendons", worst(stiffness_mismatch), 1e-9}};
  // Where radii are constant; a search has a start as well and is tested by itself.
  if (model.offers("link_position") && !model.offers("link_position_warm"))
    checks.push_back({"link positions from tendon lengths", worst(position_error), 1e-13});
  return checks;
}

}  // namespace sinew::reference

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/numeric/odeint.hpp>

#include "tests/symbolic/dynamics/deviation.h"
#include "tests/symbolic/dynamics/emitted_functions.h"
#include "tests/symbolic/dynamics/mechanics_checks.h"

namespace sinew::reference {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// rad or m along a direction whose largest entry is 1.
constexpr double kStep = 0.004;

double largest(const MatrixXd& values) {
  return values.allFinite() ? values.cwiseAbs().maxCoeff()
                            : std::numeric_limits<double>::infinity();
}

VectorXd direction(const VectorXd& rate) {
  return rate.isZero(0.0) ? VectorXd(VectorXd::Ones(rate.size())) : VectorXd(rate / largest(rate));
}

/// Worst over the states of a difference divided by a size.
struct Worst {
  double value = 0.0;
  void see(const MatrixXd& difference, double size) {
    const double next = largest(difference) / (size > 0.0 ? size : 1.0);
    value = next <= value ? value : next;
  }
};

double mass_matrix_asymmetry(const EmittedFunctions& model, const std::vector<State>& states) {
  Worst worst;
  for (const State& at : states) {
    const MatrixXd mass = model("mass_matrix", {at.q});
    worst.see(mass - mass.transpose(), 1.0);
  }
  return worst.value;
}

double mass_matrix_indefiniteness(const EmittedFunctions& model, const std::vector<State>& states) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const State& at : states) {
    const MatrixXd mass = model("mass_matrix", {at.q});
    smallest = std::min(smallest, Eigen::SelfAdjointEigenSolver<MatrixXd>(mass).eigenvalues()[0]);
  }
  return -smallest;
}

double passivity_violation(const EmittedFunctions& model, const std::vector<State>& states) {
  Worst worst;
  double size = 0.0;
  for (const State& at : states) {
    const VectorXd along = direction(at.qd);
    const MatrixXd rate = derivative_at_zero(
        [&](double t) { return model("mass_matrix", {at.q + t * along}); }, kStep);
    const MatrixXd coriolis = model("coriolis_matrix", {at.q, along});
    worst.see(rate - coriolis - coriolis.transpose(), 1.0);
    size = std::max(size, largest(model("mass_matrix", {at.q})));
  }
  return worst.value / size;
}

double bias_mismatch(const EmittedFunctions& model, const std::vector<State>& states) {
  Worst worst;
  double size = 0.0;
  for (const State& at : states) {
    const VectorXd bias = model("bias", {at.q, at.qd});
    const VectorXd sum = model("coriolis_matrix", {at.q, at.qd}) * at.qd + model("gravity", {at.q});
    worst.see(bias - sum, 1.0);
    size = std::max(size, largest(bias));
  }
  return worst.value / size;
}

double inverse_dynamics_mismatch(const EmittedFunctions& model, const std::vector<State>& states) {
  Worst worst;
  double size = 0.0;
  for (const State& at : states) {
    const VectorXd tau = model("inverse_dynamics", {at.q, at.qd, at.qdd});
    const VectorXd sum = model("mass_matrix", {at.q}) * at.qdd + model("bias", {at.q, at.qd});
    worst.see(tau - sum, 1.0);
    size = std::max(size, largest(tau));
  }
  return worst.value / size;
}

/// Columns of M as torques of unit accelerations; the velocity terms must cancel.
double unit_acceleration_mismatch(const EmittedFunctions& model, const std::vector<State>& states) {
  Worst worst;
  for (const State& at : states) {
    const MatrixXd mass = model("mass_matrix", {at.q});
    const VectorXd rest = VectorXd::Zero(at.q.size());
    const VectorXd weight = model("inverse_dynamics", {at.q, rest, rest});
    for (Eigen::Index j = 0; j < at.q.size(); ++j) {
      const VectorXd unit = VectorXd::Unit(at.q.size(), j);
      worst.see(model("inverse_dynamics", {at.q, rest, unit}) - weight - mass.col(j),
                largest(mass) + largest(weight));
    }
  }
  return worst.value;
}

double forward_dynamics_residual(const EmittedFunctions& model, const std::vector<State>& states) {
  Worst worst;
  for (const State& at : states) {
    const VectorXd qdd = model("forward_dynamics", {at.q, at.qd, at.tau});
    const double condition = condition_number(model("mass_matrix", {at.q}));
    worst.see((qdd - at.qdd) / condition, std::max(largest(at.qdd), 1.0));
  }
  return worst.value;
}

/// J column by column against the emitted pose: linear rows from its translation, angular rows from
/// the skew part of (dR/dt) R^T.
double jacobian_mismatch(const EmittedFunctions& model, const std::vector<State>& states) {
  Worst worst;
  for (const State& at : states) {
    const VectorXd along = direction(at.qd);
    const MatrixXd rate = derivative_at_zero(
        [&](double t) { return model("forward_kinematics", {at.q + t * along}); }, kStep);
    const MatrixXd turning = rate.topLeftCorner(3, 3) *
                             model("forward_kinematics", {at.q}).topLeftCorner(3, 3).transpose();
    VectorXd twist(6);
    twist << rate.topRightCorner(3, 1), turning(2, 1), turning(0, 2), turning(1, 0);
    worst.see(model("tip_jacobian", {at.q}) * along - twist, static_cast<double>(at.q.size()));
  }
  return worst.value;
}

}  // namespace

std::vector<LawCheck> rigid_body_laws(const EmittedModel& emitted,
                                      const std::vector<State>& states) {
  const EmittedFunctions model(emitted);
  std::vector<LawCheck> checks = {
      {"M is symmetric to the bit", mass_matrix_asymmetry(model, states), 0.0},
      {"M is positive definite (minus its least eigenvalue)",
       mass_matrix_indefiniteness(model, states), -1e-15},
      {"Mdot - 2C is skew-symmetric", passivity_violation(model, states), 1e-10},
      {"C qd + g = bias", bias_mismatch(model, states), 1e-13},
      {"M qdd + bias = inverse dynamics", inverse_dynamics_mismatch(model, states), 1e-13},
      {"M from unit accelerations", unit_acceleration_mismatch(model, states), 1e-13},
      {"forward dynamics inverts inverse dynamics", forward_dynamics_residual(model, states),
       1e-13}};
  if (model.offers("tip_jacobian"))
    checks.push_back({"J is the tip's derivative", jacobian_mismatch(model, states), 1e-10});
  return checks;
}

LawCheck energy_law(const EmittedModel& emitted, const Mechanism& mechanism, const State& start,
                    double seconds) {
  using Numbers = std::vector<double>;
  namespace odeint = boost::numeric::odeint;
  const EmittedFunctions model(emitted);
  const NewtonEuler<double> masses(mechanism);
  const auto n = static_cast<Eigen::Index>(start.q.size());
  const auto motion = [&](const Numbers& now, Numbers& rate, double) {
    const Eigen::Map<const VectorXd> x(now.data(), 2 * n);
    Eigen::Map<VectorXd> dx(rate.data(), 2 * n);
    dx.head(n) = x.tail(n);
    dx.tail(n) = model("forward_dynamics", {x.head(n), x.tail(n), VectorXd::Zero(n)});
  };
  const auto kinetic = [&](const VectorXd& x) {
    return 0.5 * x.tail(n).dot(model("mass_matrix", {x.head(n)}) * x.tail(n));
  };
  Numbers now(static_cast<std::size_t>(2 * n));
  Eigen::Map<VectorXd> x(now.data(), 2 * n);
  x << start.q, start.qd;
  const double before = kinetic(x) + masses.potential_energy(x.head(n));
  double size = kinetic(x);
  auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<Numbers>>(1e-12, 1e-12);
  odeint::integrate_adaptive(
      stepper, motion, now, 0.0, seconds, 1e-4, [&](const Numbers& seen, double) {
        size = std::max(size, kinetic(Eigen::Map<const VectorXd>(seen.data(), 2 * n)));
      });
  const double after = kinetic(x) + masses.potential_energy(x.head(n));
  return {"energy is conserved in free motion", std::abs(after - before) / size, 1e-9};
}

std::string describe(const std::vector<LawCheck>& checks) {
  std::string table;
  for (const LawCheck& check : checks)
    table += fmt::format("{} {:10.2e} (limit {:.0e}) {}\n", check.holds() ? " " : "X",
                         check.violation, check.limit, check.law);
  return table;
}

}  // namespace sinew::reference

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/symbolic/dynamics/deviation.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace sinew::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Largest difference; infinite where a number is not finite (which no comparison would show).
double distance(const std::vector<double>& emitted, const VectorX<double>& expected) {
  if (std::ssize(emitted) != expected.size()) return kInfinity;
  const Eigen::Map<const Eigen::VectorXd> values(emitted.data(), std::ssize(emitted));
  return values.allFinite() ? (values - expected).cwiseAbs().maxCoeff() : kInfinity;
}

double distance(const std::vector<double>& emitted, const VectorX<Real50>& expected) {
  if (std::ssize(emitted) != expected.size()) return kInfinity;
  double worst = 0.0;
  for (std::size_t i = 0; i < emitted.size(); ++i) {
    if (!std::isfinite(emitted[i])) return kInfinity;
    const Real50 difference = Real50(emitted[i]) - expected[static_cast<Eigen::Index>(i)];
    worst = std::max(worst, std::abs(static_cast<double>(difference)));
  }
  return worst;
}

/// Inputs that a float model receives unchanged.
void round_to_float(State& state) {
  for (Eigen::VectorXd* values :
       {&state.q, &state.qd, &state.qdd, &state.tau, &state.f, &state.kt, &state.h})
    *values = values->cast<float>().cast<double>();
}

struct Comparison {
  const EmittedModel& emitted;
  const std::vector<State>& states;
  const std::vector<double>& conditions;  ///< of M at each state
  ReferenceModel<double> coarse;
  ReferenceModel<Real50> fine;
  int exact_states;
  double precision;  ///< 2^-53 or 2^-24

  Deviation run(const std::string& function) const;
};

Deviation Comparison::run(const std::string& function) const {
  const sinew_function* called = emitted.find(function);
  if (called == nullptr) return {function, kInfinity, kInfinity, 0.0, 0};
  Deviation worst{function};
  std::vector<double> sizes, errors;
  std::vector<std::vector<double>> results;
  for (const State& state : states) {
    results.push_back(emitted.call(*called, inputs_of(function, state)));
    const VectorX<double> expected = coarse.evaluate(function, state);
    sizes.push_back(expected.cwiseAbs().maxCoeff());
    errors.push_back(distance(results.back(), expected));
    worst.scale = std::max(worst.scale, sizes.back());
  }
  const bool solves = function == "forward_dynamics";
  const double best = *std::min_element(conditions.begin(), conditions.end());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double size = std::max(sizes[i], 0.01 * worst.scale);
    if (size == 0.0 && errors[i] == 0.0) continue;
    worst.relative =
        std::max(worst.relative, errors[i] / size / (solves ? conditions[i] / best : 1.0));
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(exact_states); ++i) {
    const double error = distance(results[i], fine.evaluate(function, states[i]));
    const double unit = precision * worst.scale * (solves ? conditions[i] : 1.0);
    if (error == 0.0 || error / unit <= worst.units) continue;
    worst.units = error / unit;
    worst.worst_state = static_cast<int>(i);
  }
  return worst;
}

}  // namespace

double condition_number(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  return values.maxCoeff() / values.minCoeff();
}

std::vector<Deviation> compare(const EmittedModel& emitted, const Mechanism& mechanism,
                               const ComparisonSize& size) {
  const bool in_float = emitted.catalogue().scalar_bytes == 4;
  std::vector<State> states = sample_states(mechanism, size.states, size.seed);
  if (in_float)
    for (State& state : states) round_to_float(state);
  const NewtonEuler<double> dynamics(mechanism);
  std::vector<double> conditions;
  for (const State& state : states)
    conditions.push_back(condition_number(dynamics.mass_matrix(state.q)));
  const Comparison comparison{emitted,
                              states,
                              conditions,
                              ReferenceModel<double>(mechanism),
                              ReferenceModel<Real50>(mechanism),
                              std::min(size.states, size.exact_states),
                              in_float ? 0x1p-24 : 0x1p-53};
  std::vector<Deviation> deviations;
  for (const std::string& function : offered_functions(mechanism))
    deviations.push_back(comparison.run(function));
  return deviations;
}

std::string describe(const std::vector<Deviation>& deviations) {
  std::string table = fmt::format("{:20} {:>10} {:>10} {:>10} {:>6}\n", "function", "relative",
                                  "units", "scale", "state");
  for (const Deviation& each : deviations)
    table += fmt::format("{:20} {:10.2e} {:10.3g} {:10.3g} {:6}\n", each.function, each.relative,
                         each.units, each.scale, each.worst_state);
  return table;
}

}  // namespace sinew::reference

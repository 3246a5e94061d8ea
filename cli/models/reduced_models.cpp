// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/models/reduced_models.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "generator/assemble.h"
#include "generator/cost.h"
#include "generator/evaluate.h"
#include "generator/lower.h"
#include "generator/passes/pipeline.h"
#include "symbolic/dynamics/dynamics_functions.h"
#include "symbolic/expressions/exact_number.h"
#include "symbolic/tendons/tendon_functions.h"

namespace sinew {
namespace {

/// The function with one of its arguments held; it stays an argument that nothing depends on.
Function holding(Function function, std::size_t argument, const std::vector<double>& values) {
  GiNaC::exmap held;
  const std::vector<GiNaC::symbol>& symbols = function.inputs[argument].symbols;
  for (std::size_t i = 0; i < symbols.size(); ++i) held[symbols[i]] = exact_number(values[i]);
  for (Definition& definition : function.definitions) {
    definition.value = definition.value.subs(held);
  }
  for (Output& output : function.outputs)
    for (GiNaC::ex& value : output.values) value = value.subs(held);
  return function;
}

/// Middle of the ranges: where a coupling would be held.
std::vector<double> middle(const Argument& argument) {
  if (!argument.reference.empty()) return argument.reference;
  std::vector<double> values;
  for (const Range& range : argument.ranges) values.push_back(0.5 * (range.low + range.high));
  return values;
}

/// mt19937 itself is the same everywhere, the library's distributions are not.
class States {
 public:
  States(const Function& function, double share) : function_(function), share_(share) {}
  std::vector<double> next() {
    std::vector<double> values;
    for (const Argument& argument : function_.inputs)
      for (const Range& range : argument.ranges) {
        const bool moves = argument.name == "qd" || argument.name == "qdd";
        const double unit = static_cast<double>(random_()) / 4294967296.0;
        values.push_back((moves ? share_ : 1.0) * (range.low + unit * (range.high - range.low)));
      }
    return values;
  }

 private:
  const Function& function_;
  double share_;
  std::mt19937 random_{1};
};

ReducedModel compare(const std::string& left_out, const Function& whole, const Function& reduced,
                     int states, double share) {
  const Graph full = optimise(lower(whole)), less = optimise(lower(reduced));
  ReducedModel result{left_out, whole.name, count_operations(full).operations(),
                      count_operations(less).operations()};
  States state(whole, share);
  const std::size_t n = whole.outputs.front().values.size();
  std::vector<double> energy(n, 0.0), error(n, 0.0), largest(n, 0.0);
  for (int k = 0; k < states; ++k) {
    const std::vector<double> at = state.next();
    const std::vector<double> a = evaluate<double>(full, at), b = evaluate<double>(less, at);
    for (std::size_t j = 0; j < n; ++j) {
      energy[j] += a[j] * a[j];
      error[j] += (a[j] - b[j]) * (a[j] - b[j]);
      largest[j] = std::max(largest[j], std::abs(a[j] - b[j]));
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (energy[j] == 0.0) continue;
    result.rms_error = std::max(result.rms_error, std::sqrt(error[j] / energy[j]));
    result.largest_error =
        std::max(result.largest_error, largest[j] / std::sqrt(energy[j] / states));
  }
  return result;
}

}  // namespace

std::vector<ReducedModel> reduced_models(const Mechanism& mechanism, int states, double share) {
  const Function dynamics = inverse_dynamics_function(mechanism, emitted_cost);
  Mechanism weightless = mechanism;
  weightless.gravity.setZero();
  const std::size_t rates = 1;  // inverse_dynamics(q, qd, qdd)
  const std::vector<double> none(dynamics.inputs[rates].symbols.size(), 0.0);
  std::vector<ReducedModel> list{
      compare("gravity", dynamics, inverse_dynamics_function(weightless, emitted_cost), states,
              share),
      compare("Coriolis and centrifugal torques", dynamics, holding(dynamics, rates, none), states,
              share)};
  for (const Function& function : tendon_functions(mechanism))
    if (function.name == "joint_torque")
      list.push_back(compare("change of the coupling", function,
                             holding(function, 0, middle(function.inputs[0])), states, share));
  return list;
}

}  // namespace sinew

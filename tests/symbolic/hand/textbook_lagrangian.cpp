// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of motion two ways: L = T - V differentiated, and the recursive form that is
// emitted; for the ring finger these are the two methods of 5.3.2.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "generator/cost.h"
#include "generator/lower.h"
#include "generator/passes/pipeline.h"
#include "symbolic/dynamics/dynamics_functions.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/dynamics/lagrangian.h"
#include "symbolic/model/read_mechanism.h"

using namespace sinew;

namespace {

Mechanism model(const std::string& name) {
  return read_mechanism(std::string(SINEW_SOURCE_DIR) + "/models/" + name);
}

Function recursive_inverse_dynamics(const Mechanism& mechanism) {
  for (const Function& function : dynamics_functions(mechanism, {}))
    if (function.name == "inverse_dynamics") return function;
  throw std::logic_error("no inverse_dynamics");
}

std::vector<GiNaC::numeric> rational_point(const Function& function, std::mt19937& random) {
  std::vector<GiNaC::numeric> point;
  for (const Argument& argument : function.inputs)
    for (const Range& range : argument.ranges)
      point.push_back(binary_fraction(
          std::round(1024 * std::uniform_real_distribution<double>(range.low, range.high)(random)) /
          1024));
  return point;
}

/// Largest difference relative to the largest torque, with 40 digits.
double disagreement(const Function& a, const Function& b) {
  std::mt19937 random(2);
  double worst = 0;
  for (int trial = 0; trial < 3; ++trial) {
    const auto point = rational_point(a, random);
    const auto x = evaluate_precisely(a, point, 40), y = evaluate_precisely(b, point, 40);
    double scale = 0, difference = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      scale = std::max(scale, std::abs(x[i].to_double()));
      difference = std::max(difference, std::abs((x[i] - y[i]).to_double()));
    }
    worst = std::max(worst, difference / scale);
  }
  return worst;
}

int operations(const Function& function) {
  return count_operations(optimise(lower(function))).operations();
}

}  // namespace

TEST_CASE("differentiating L = T - V gives the recursive form", "[lagrangian]") {
  for (const char* name : {"index", "ring", "fifth"}) {
    const Mechanism mechanism = model(name);
    const Function textbook = textbook_inverse_dynamics(mechanism),
                   recursive = recursive_inverse_dynamics(mechanism);
    const double error = disagreement(textbook, recursive);
    const int by_definition = operations(textbook), by_recursion = operations(recursive);
    fmt::print(
        "{}: inverse dynamics, L differentiated {} operations, recursive {}, "
        "difference {:.1e}\n",
        name, by_definition, by_recursion, error);
    // The fifth finger's scaled lengths are doubles of many digits; the recursion's frames add some
    // of them up, and to_expression (spatial.h) rounds such a sum to a double.
    CHECK(error < (std::string(name) == "fifth" ? 0x1p-52 : 1e-35));
    CHECK(by_recursion <= by_definition);
  }
}

TEST_CASE("both methods of 5.3.2 give the same torques for ring and fifth finger", "[lagrangian]") {
  for (const char* name : {"ring", "fifth"}) {
    const Mechanism mechanism = model(name);
    const Function in_lagrangian = textbook_inverse_dynamics(mechanism),
                   projected = projected_inverse_dynamics(mechanism);
    const double error = disagreement(in_lagrangian, projected);
    fmt::print("{}: couplings in L {} operations, four joints projected {}, difference {:.1e}\n",
               name, operations(in_lagrangian), operations(projected), error);
    CHECK(error < 1e-35);
  }
  // Planted: another ratio in one of them.
  Mechanism ring = model("ring");
  const Function in_lagrangian = textbook_inverse_dynamics(ring);
  ring.couplings[0].ratio *= 1.001;
  CHECK(disagreement(projected_inverse_dynamics(ring), in_lagrangian) > 1e-5);
}

TEST_CASE("a missing Coriolis term and a wrong coupling ratio show", "[lagrangian]") {
  Mechanism ring = model("ring");
  const Function recursive = recursive_inverse_dynamics(ring);
  ring.couplings[0].ratio = 1 / ring.couplings[0].ratio;  // as (5.16) prints it
  CHECK(disagreement(textbook_inverse_dynamics(ring), recursive) > 1e-3);
  const Mechanism index = model("index");
  Function slow = textbook_inverse_dynamics(index);
  GiNaC::exmap still;
  for (const GiNaC::symbol& rate : slow.inputs[1].symbols) still[rate] = 0;
  for (Definition& definition : slow.definitions) definition.value = definition.value.subs(still);
  for (GiNaC::ex& tau : slow.outputs[0].values) tau = tau.subs(still);
  CHECK(disagreement(slow, recursive_inverse_dynamics(index)) > 1e-3);
}

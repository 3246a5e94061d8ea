// SPDX-License-Identifier: GPL-3.0-or-later
// Masses as arguments: base_parameters of the model's own bodies must give the model's dynamics.
#include <catch2/catch.hpp>

#include "generator/evaluate.h"
#include "generator/lower.h"
#include "symbolic/dynamics/dynamics_functions.h"
#include "symbolic/model/read_mechanism.h"

namespace {

using sinew::Exact;
using sinew::Function;
using sinew::Mechanism;

const Function& named(const std::vector<Function>& functions, const std::string& name) {
  for (const Function& function : functions)
    if (function.name == name) return function;
  FAIL("no function is called " << name);
  throw 0;
}

/// Mass, centre of mass, inertia of all bodies and gravity: the input of base_parameters.
std::vector<Exact> mass_properties(const Mechanism& mechanism) {
  std::vector<Exact> mass, com, inertia;
  for (const sinew::Body& body : mechanism.bodies) {
    mass.emplace_back(body.mass);
    for (int k = 0; k < 3; ++k) com.emplace_back(body.centre_of_mass(k));
    const Eigen::Matrix3d& I = body.inertia;
    for (double value : {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)})
      inertia.emplace_back(value);
  }
  std::vector<Exact> all = mass;
  all.insert(all.end(), com.begin(), com.end());
  all.insert(all.end(), inertia.begin(), inertia.end());
  for (int k = 0; k < 3; ++k) all.emplace_back(mechanism.gravity(k));
  return all;
}

/// Largest difference of the inverse dynamics between both modes, relative to the torques.
double difference(const Mechanism& mechanism, std::vector<Exact> masses) {
  const auto fixed = sinew::dynamics_functions(mechanism, {});
  const auto open = sinew::dynamics_functions(mechanism, {}, true);
  const auto parameters = sinew::evaluate(sinew::lower(named(open, "base_parameters")), masses);
  std::vector<Exact> state;
  const int n = sinew::coordinate_count(mechanism);
  for (int i = 0; i < 3 * n; ++i) state.emplace_back(0.3 + 0.17 * i - 0.02 * i * i);
  std::vector<Exact> with_parameters = state;
  with_parameters.insert(with_parameters.end(), parameters.begin(), parameters.end());
  const auto expected = sinew::evaluate(sinew::lower(named(fixed, "inverse_dynamics")), state);
  const auto actual =
      sinew::evaluate(sinew::lower(named(open, "inverse_dynamics")), with_parameters);
  double scale = 0, worst = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    scale = std::max(scale, std::abs(static_cast<double>(expected[i])));
    worst = std::max(worst, std::abs(static_cast<double>(expected[i] - actual[i])));
  }
  return worst / scale;
}

}  // namespace

TEST_CASE("runtime parameters give the dynamics of the masses they come from") {
  const Mechanism index = sinew::read_mechanism(SINEW_SOURCE_DIR "/models/index");
  // base parameters are rounded once in the fixed mode: a few units of 2^-53
  CHECK(difference(index, mass_properties(index)) < 1e-14);
  std::vector<Exact> wrong = mass_properties(index);
  wrong[1] *= Exact("1.000000001");  // a planted mistake: one mass off by 1e-9
  CHECK(difference(index, wrong) > 1e-11);
}

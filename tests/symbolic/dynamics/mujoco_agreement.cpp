// SPDX-License-Identifier: GPL-3.0-or-later
// The reference against MuJoCo, which knows nothing of this project.
#include <catch2/catch.hpp>

#include "tests/reference/mujoco_truth.h"
#include "tests/reference/newton_euler.h"
#include "tests/reference/random_mechanism.h"
#include "tests/reference/sampling.h"
#include "tests/skip.h"

namespace sinew::reference {
namespace {

/// Largest difference over the largest value, over mass matrix, bias and inverse dynamics.
double disagreement(MujocoTruth& truth, const Mechanism& mechanism, int states) {
  const NewtonEuler<double> dynamics(mechanism);
  const auto positions = sample_box(position_box(mechanism), states, 1);
  const auto rates = sample_box(velocity_box(mechanism), states, 2);
  const auto accelerations = sample_box(acceleration_box(mechanism), states, 3);
  double worst = 0.0;
  const auto compare = [&](const Eigen::MatrixXd& one, const Eigen::MatrixXd& other) {
    worst = std::max(worst, (one - other).cwiseAbs().maxCoeff() / other.cwiseAbs().maxCoeff());
  };
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto view = [](const std::vector<double>& values) {
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values)));
    };
    const Eigen::VectorXd q = view(positions[i]);
    const Eigen::VectorXd qd = view(rates[i]);
    const Eigen::VectorXd qdd = view(accelerations[i]);
    compare(dynamics.mass_matrix(q), truth.mass_matrix(q));
    compare(dynamics.bias(q, qd), truth.bias(q, qd));
    compare(dynamics.inverse_dynamics(q, qd, qdd), truth.inverse_dynamics(q, qd, qdd));
  }
  return worst;
}

TEST_CASE("MuJoCo agrees with the reference") {
  if (!mujoco_available()) return test::skip("MuJoCo is not installed (libmujoco-dev)");
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RandomMechanismOptions options;
    options.joints = 2 + static_cast<int>(seed);
    options.branched = seed > 4;
    options.arm = seed % 2 == 0;
    Mechanism mechanism = random_mechanism(seed, options);
    MujocoTruth truth(mechanism);
    CHECK(disagreement(truth, mechanism, 50) < 1e-12);
    mechanism.bodies.back().mass *= 1.0 + 1e-9;
    CHECK(disagreement(truth, mechanism, 50) > 1e-12);
  }
}

}  // namespace
}  // namespace sinew::reference

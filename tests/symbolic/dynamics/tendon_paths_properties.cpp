// SPDX-License-Identifier: GPL-3.0-or-later
// The reference's tendons against derivatives taken with 50 digits (central differences, step
// 1e-12, good to 1e-22), on paths of pulleys and of straight stretches.
#include "tests/reference/tendon_paths.h"

#include <catch2/catch.hpp>

#include "tests/reference/random_mechanism.h"
#include "tests/reference/sampling.h"

namespace sinew::reference {
namespace {

using Vector = VectorX<Real50>;
using Matrix = MatrixX<Real50>;

/// A tree with sliding and fixed joints whose tendon runs base - first body - last body.
Mechanism tendon_tree(std::uint64_t seed) {
  RandomMechanismOptions options;
  options.joints = 6;
  options.branched = seed % 2 == 0;
  Mechanism mechanism = random_mechanism(seed, options);
  Tendon tendon;
  tendon.name = "straight";
  tendon.h0 = 0.01;
  tendon.pulleys = {{mechanism.joints.back().name, 0.005}};
  tendon.straights = {
      {"base", {0.01, 0.02, 0.03}, mechanism.bodies.front().name, {-0.02, 0.05, 0.01}},
      {mechanism.bodies[1].name,
       {0.03, -0.01, 0.02},
       mechanism.bodies.back().name,
       {0.0, 0.02, 0.04}}};
  mechanism.tendons.push_back(tendon);
  return mechanism;
}

double largest(const Matrix& values) {
  return static_cast<double>(values.cwiseAbs().maxCoeff());
}

TEST_CASE("the reference's tendon derivatives are derivatives") {
  const Real50 step("1e-12");
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Mechanism mechanism = tendon_tree(seed);
    const TendonPaths<Real50> tendons(mechanism);
    const auto sampled = sample_box(position_box(mechanism), 5, seed).back();
    const Vector q = convert<Real50>(
        VectorX<double>(Eigen::Map<const VectorX<double>>(sampled.data(), std::ssize(sampled))));
    const Matrix coupling = tendons.coupling_matrix(q);
    const Matrix hessian = tendons.length_hessian(q, 0);
    CHECK(largest(hessian) > 1e-4);
    CHECK(largest(hessian - hessian.transpose()) < 1e-45);
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      const Vector shift = Vector::Unit(q.size(), k) * step;
      const Real50 slope =
          (tendons.lengths(q + shift)[0] - tendons.lengths(q - shift)[0]) / step / 2;
      const Matrix bend =
          (tendons.coupling_matrix(q + shift) - tendons.coupling_matrix(q - shift)) /
          Real50(step * 2);
      CHECK(static_cast<double>(abs(slope - coupling(0, k))) < 1e-18);
      CHECK(largest(bend - hessian.row(k)) < 1e-18);
    }
  }
}

}  // namespace
}  // namespace sinew::reference

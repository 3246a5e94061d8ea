// SPDX-License-Identifier: GPL-3.0-or-later
// The reference itself against mechanics: energies, derivatives, Christoffel's definition.
// Everything here is evaluated with 50 digits, so central differences with a step of 1e-12 are good
// to 1e-22.
#include "tests/reference/newton_euler.h"

#include <catch2/catch.hpp>

#include "tests/reference/random_mechanism.h"
#include "tests/reference/sampling.h"

namespace sinew::reference {
namespace {

using Vector = VectorX<Real50>;
using Matrix = MatrixX<Real50>;

const Real50 kStep("1e-12");
const double kTolerance = 1e-18;

Vector as_vector(const std::vector<double>& values) {
  return convert<Real50>(
      VectorX<double>(Eigen::Map<const VectorX<double>>(values.data(), std::ssize(values))));
}

/// d value / dq_k by central differences.
template <class Function>
auto slope(const Function& value, const Vector& q, int k) {
  const Vector step = Vector::Unit(q.size(), k) * kStep;
  using Result = decltype(value(q));
  return Result((value(q + step) - value(q - step)) / (Real50(2) * kStep));
}

double distance(const Matrix& one, const Matrix& other) {
  return static_cast<double>((one - other).cwiseAbs().maxCoeff()) /
         (1e-30 + static_cast<double>(other.cwiseAbs().maxCoeff()));
}

/// Gamma_ijk = (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) / 2, C_ij = sum_k Gamma_ijk qd_k.
Matrix christoffel(const NewtonEuler<Real50>& dynamics, const Vector& q, const Vector& qd) {
  const int n = dynamics.size();
  std::vector<Matrix> derivative;
  for (int k = 0; k < n; ++k)
    derivative.push_back(slope([&](const Vector& at) { return dynamics.mass_matrix(at); }, q, k));
  const auto d = [&](int i, int j, int k) { return derivative[static_cast<std::size_t>(k)](i, j); };
  Matrix coriolis = Matrix::Zero(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        coriolis(i, j) += (d(i, j, k) + d(i, k, j) - d(j, k, i)) * qd[k] / Real50(2);
  return coriolis;
}

/// A few mechanisms of every sort, each with one state.
struct Case {
  Mechanism mechanism;
  Vector q, qd, qdd;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    RandomMechanismOptions options;
    options.joints = 2 + static_cast<int>(seed);
    options.arm = seed % 2 == 0;
    options.branched = seed > 2;
    Case each{random_mechanism(seed, options), {}, {}, {}};
    each.q = as_vector(sample_box(position_box(each.mechanism), 5, seed).back());
    each.qd = as_vector(sample_box(velocity_box(each.mechanism), 6, seed).back());
    each.qdd = as_vector(sample_box(acceleration_box(each.mechanism), 7, seed).back());
    all.push_back(each);
  }
  return all;
}

TEST_CASE("the reference's Coriolis matrix is Christoffel's by definition") {
  for (const Case& each : cases()) {
    const NewtonEuler<Real50> dynamics(each.mechanism);
    const Matrix expected = christoffel(dynamics, each.q, each.qd);
    CHECK(distance(dynamics.coriolis_matrix(each.q, each.qd), expected) < kTolerance);
  }
}

TEST_CASE("the reference's torques add up to its matrices") {
  for (const Case& each : cases()) {
    const NewtonEuler<Real50> dynamics(each.mechanism);
    const Vector sum = dynamics.mass_matrix(each.q) * each.qdd +
                       dynamics.coriolis_matrix(each.q, each.qd) * each.qd +
                       dynamics.gravity(each.q);
    const Vector tau = dynamics.inverse_dynamics(each.q, each.qd, each.qdd);
    CHECK(distance(sum, tau) < 1e-40);
    CHECK(distance(dynamics.forward_dynamics(each.q, each.qd, tau), each.qdd) < 1e-40);
  }
}

TEST_CASE("the reference's matrices are derivatives of its energies") {
  for (const Case& each : cases()) {
    const NewtonEuler<Real50> dynamics(each.mechanism);
    const Vector momentum = dynamics.mass_matrix(each.q) * each.qd;
    for (int k = 0; k < dynamics.size(); ++k) {
      const Real50 weight =
          slope([&](const Vector& at) { return dynamics.potential_energy(at); }, each.q, k);
      CHECK(static_cast<double>(abs(weight - dynamics.gravity(each.q)[k])) < kTolerance);
      const Real50 impulse =
          slope([&](const Vector& at) { return dynamics.kinetic_energy(each.q, at); }, each.qd, k);
      CHECK(static_cast<double>(abs(impulse - momentum[k])) < kTolerance);
    }
  }
}

TEST_CASE("the reference's tip Jacobian is the derivative of the tip's pose") {
  for (const Case& each : cases()) {
    const NewtonEuler<Real50> dynamics(each.mechanism);
    const Matrix pose = dynamics.forward_kinematics(each.q);
    const Matrix jacobian = dynamics.tip_jacobian(each.q);
    for (int k = 0; k < dynamics.size(); ++k) {
      const Matrix rate =
          slope([&](const Vector& at) { return dynamics.forward_kinematics(at); }, each.q, k);
      const Matrix turning = rate.topLeftCorner(3, 3) * pose.topLeftCorner(3, 3).transpose();
      const Vector3<Real50> spin(turning(2, 1), turning(0, 2), turning(1, 0));
      CHECK(static_cast<double>(
                (rate.topRightCorner(3, 1) - jacobian.block(0, k, 3, 1)).cwiseAbs().maxCoeff()) <
            kTolerance);
      CHECK(static_cast<double>((spin - jacobian.block(3, k, 3, 1)).cwiseAbs().maxCoeff()) <
            kTolerance);
    }
  }
}

TEST_CASE("a point mass on a rod is the textbook's pendulum") {
  Mechanism pendulum;
  pendulum.gravity = {0.0, -9.81, 0.0};
  pendulum.bodies.push_back(
      {"rod", "", 2.0, {0.5, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 0.1, {}});
  pendulum.joints.emplace_back();
  const NewtonEuler<double> dynamics(pendulum);
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, 0.3);
  CHECK(dynamics.mass_matrix(q)(0, 0) == Approx(2.0 * 0.25 + 0.1).epsilon(1e-15));
  CHECK(dynamics.gravity(q)[0] == Approx(2.0 * 9.81 * 0.5 * std::cos(0.3)).epsilon(1e-15));
}

TEST_CASE("double and 50 digits are the same mechanics") {
  for (const Case& each : cases()) {
    const NewtonEuler<double> coarse(each.mechanism);
    const NewtonEuler<Real50> fine(each.mechanism);
    const Eigen::VectorXd tau = coarse.inverse_dynamics(
        convert<double>(each.q), convert<double>(each.qd), convert<double>(each.qdd));
    const Vector exact = fine.inverse_dynamics(each.q, each.qd, each.qdd);
    CHECK(distance(convert<Real50>(tau), exact) < 1e-13);
    CHECK(distance(convert<Real50>(tau), exact) > 1e-20);
  }
}

}  // namespace
}  // namespace sinew::reference

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/symbolic/hand/coupled_check.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace sinew_tests {

using Vector = CoupledReference::Vector;
using Matrix = CoupledReference::Matrix;

Vector exact(const Values& values) {
  Vector result(Eigen::Index(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) result[Eigen::Index(i)] = values[i];
  return result;
}

namespace {

/// Largest difference from the reference, relative to its largest element.
double deviation(const Values& found, const Matrix& expected) {
  REQUIRE(Eigen::Index(found.size()) == expected.size());
  double worst = 0, scale = 0;
  for (Eigen::Index i = 0; i < expected.rows(); ++i)
    for (Eigen::Index j = 0; j < expected.cols(); ++j) {
      const double wanted = static_cast<double>(expected(i, j));
      const double error = std::abs(found[std::size_t(i * expected.cols() + j)] - wanted);
      worst = error <= worst ? worst : error;  // NaN must not pass as small
      scale = std::max(scale, std::abs(wanted));
    }
  return worst / std::max(scale, 1e-6);  // what is 0 has no size of its own
}

}  // namespace

std::vector<std::pair<std::string, double>> deviations(const Model& emitted,
                                                       const CoupledReference& reference,
                                                       const State& s) {
  const Vector q = exact(s.q), qd = exact(s.qd), qdd = exact(s.qdd), f = exact(s.f),
               kt = exact(s.kt);
  const Vector bias = reference.inverse_dynamics(q, qd, Vector::Zero(q.size()));
  const Matrix P = reference.coupling_matrix(q);
  return {
      {"forward_kinematics", deviation(emitted("forward_kinematics", s.q), reference.tip_pose(q))},
      {"tip_jacobian", deviation(emitted("tip_jacobian", s.q), reference.tip_jacobian(q))},
      {"mass_matrix", deviation(emitted("mass_matrix", s.q), reference.mass_matrix(q))},
      {"bias", deviation(emitted("bias", joined(s.q, s.qd)), bias)},
      {"inverse_dynamics", deviation(emitted("inverse_dynamics", joined(joined(s.q, s.qd), s.qdd)),
                                     reference.inverse_dynamics(q, qd, qdd))},
      {"tendon_lengths", deviation(emitted("tendon_lengths", s.q), reference.lengths(q))},
      {"coupling_matrix", deviation(emitted("coupling_matrix", s.q), P)},
      {"tendon_hessian", deviation(emitted("tendon_hessian", s.q), reference.hessians(q))},
      {"joint_torque",
       deviation(emitted("joint_torque", joined(s.q, s.f)), Matrix(-P.transpose() * f))},
      {"joint_stiffness", deviation(emitted("joint_stiffness", joined(joined(s.q, s.f), s.kt)),
                                    reference.stiffness(q, f, kt))}};
}

}  // namespace sinew_tests

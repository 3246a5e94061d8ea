// SPDX-License-Identifier: GPL-3.0-or-later
// The header of models/index as a user has it: spans, and Eigen where it is there.
#include <cmath>
#include <cstdio>

#include "sinew_index.hpp"

int main() {
  const std::array<double, 4> q{0.1, 0.7, 0.6, 0.5};
  std::array<double, 16> M{};
  sinew_index::mass_matrix(q, M);
  std::array<double, 16> direct{};
  index_mass_matrix(q.data(), direct.data());
  if (M != direct || !(M[0] > 0.0)) return 1;
  if (sinew_index::joints[1] != "q21" || sinew_index::tendons.size() != 8) return 2;
#ifdef SINEW_INDEX_EIGEN
  const auto seen = sinew_index::as_matrix<4, 4>(std::span<const double, 16>(M));
  const sinew_index::Matrix<4, 1> angles(q.data()), rates = sinew_index::Matrix<4, 1>::Ones();
  if (sinew_index::mass_matrix(angles) != seen) return 3;
  const auto both = sinew_index::mass_matrix_and_bias(angles, rates);
  if (both.M != seen || both.h != sinew_index::bias(angles, rates)) return 4;
  // tau = -P^T f, by Eigen's product and by the emitted function; expressions are taken, too.
  const sinew_index::Matrix<8, 1> f = sinew_index::Matrix<8, 1>::Constant(3.0);
  const Eigen::Vector4d tau = -sinew_index::coupling_matrix(angles).transpose() * (2 * f);
  if ((tau - sinew_index::joint_torque(angles, 2 * f)).norm() > 1e-12) return 5;
  std::puts("with Eigen");
#else
  std::puts("without Eigen");
#endif
  return 0;
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/link_motion.h"

namespace sinew {

using GiNaC::ex;

Motion motion_at_rest(const Vector3ex& gravity) {
  return {zero_vector(), zero_vector(), zero_matrix(), {-gravity[0], -gravity[1], -gravity[2]}};
}

Motion fixed_frame_motion(DefinitionList& list, const std::string& name, const Motion& carrier,
                          const NumberMatrix3& R, const NumberVector3& p) {
  Motion motion;
  motion.w = named(list, "v" + name, transpose_times(R, carrier.w));
  motion.alpha = named(list, "e" + name, transpose_times(R, carrier.alpha));
  Matrix3ex half;  // U R, then R^T (U R)
  for (std::size_t i = 0; i < 3; ++i)
    half[i] = named(list, "H" + name + std::to_string(i), transpose_times(R, carrier.U[i]));
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector3ex column = named(list, "G" + name + std::to_string(j),
                                   transpose_times(R, {half[0][j], half[1][j], half[2][j]}));
    for (std::size_t i = 0; i < 3; ++i) motion.U[i][j] = column[i];
  }
  const Vector3ex moved = times(carrier.U, to_expression(p));
  const Vector3ex acceleration = named(list, "b" + name, carrier.a + moved);
  motion.a = named(list, "d" + name, transpose_times(R, acceleration));
  return motion;
}

void complete_rotation_rates(DefinitionList& list, const std::string& name, Motion& m) {
  const ex xx = named(list, "w" + name + "xx", m.w[0] * m.w[0]);
  const ex yy = named(list, "w" + name + "yy", m.w[1] * m.w[1]);
  const ex zz = named(list, "w" + name + "zz", m.w[2] * m.w[2]);
  const ex xy = named(list, "w" + name + "xy", m.w[0] * m.w[1]);
  const ex xz = named(list, "w" + name + "xz", m.w[0] * m.w[2]);
  const ex yz = named(list, "w" + name + "yz", m.w[1] * m.w[2]);
  m.alpha[0] = named(list, "al" + name + "x", yz - m.U[1][2]);
  m.alpha[1] = named(list, "al" + name + "y", m.U[0][2] - xz);
  m.U[0][0] = named(list, "U" + name + "xx", -yy - zz);
  m.U[1][1] = named(list, "U" + name + "yy", -xx - zz);
  m.U[0][1] = named(list, "U" + name + "xy", xy - m.alpha[2]);
  m.U[1][0] = named(list, "U" + name + "yx", xy + m.alpha[2]);
  m.U[2][0] = named(list, "U" + name + "zx", xz - m.alpha[1]);
  m.U[2][1] = named(list, "U" + name + "zy", yz + m.alpha[0]);
}

Motion turned_motion(DefinitionList& list, const std::string& name, const Motion& before,
                     const CosSin& angle, const ex& qd, const ex& qdd) {
  Motion m;
  m.w = turn_back(angle, before.w);
  m.w[2] = before.w[2] + qd;
  m.w = named(list, "w" + name, m.w);
  const Vector3ex column = named(
      list, "U" + name + "z", turn_back(angle, {before.U[0][2], before.U[1][2], before.U[2][2]}));
  for (std::size_t i = 0; i < 3; ++i) m.U[i][2] = column[i];
  m.alpha[2] = named(list, "al" + name + "z", before.alpha[2] + qdd);
  complete_rotation_rates(list, name, m);
  m.a = named(list, "a" + name, turn_back(angle, before.a));
  return m;
}

Motion slid_motion(DefinitionList& list, const std::string& name, const Motion& before, const ex& q,
                   const ex& qd, const ex& qdd) {
  Motion m = before;
  const ex twice = named(list, "u" + name, 2 * qd);
  const ex x = before.a[0] + before.U[0][2] * q + twice * before.w[1];
  const ex y = before.a[1] + before.U[1][2] * q - twice * before.w[0];
  const ex z = before.a[2] + before.U[2][2] * q + qdd;
  m.a = named(list, "a" + name, Vector3ex{x, y, z});
  return m;
}

Wrench inertial_wrench(DefinitionList& list, const std::string& name, const PseudoInertia& inertia,
                       const Motion& m) {
  const auto J = [&](std::size_t i, std::size_t j) { return inertia[i][j]; };
  const Vector3ex s{J(0, 3), J(1, 3), J(2, 3)};
  const Matrix3ex& U = m.U;
  const ex xx = m.w[0] * m.w[0], yy = m.w[1] * m.w[1], zz = m.w[2] * m.w[2];
  const ex zz_yy = named(list, "D" + name + "x", zz - yy);  // U_zz and its like differ by squares
  const ex xx_zz = named(list, "D" + name + "y", xx - zz);
  const ex yy_xx = named(list, "D" + name + "z", yy - xx);
  Wrench result;
  result.F = times(U, s);
  for (std::size_t i = 0; i < 3; ++i) result.F[i] += J(3, 3) * m.a[i];
  // U_zz - U_yy = w_y^2... written with the squares, so that equal differences are shared
  result.N[0] = J(0, 1) * U[2][0] + J(1, 1) * U[2][1] - J(0, 2) * U[1][0] + J(1, 2) * zz_yy -
                J(2, 2) * U[1][2];
  result.N[1] = J(0, 2) * xx_zz + J(1, 2) * U[0][1] + J(2, 2) * U[0][2] - J(0, 0) * U[2][0] -
                J(0, 1) * U[2][1];
  result.N[2] = J(0, 0) * U[1][0] - J(1, 1) * U[0][1] + J(0, 1) * yy_xx + J(0, 2) * U[1][2] -
                J(1, 2) * U[0][2];
  const Vector3ex lever = cross(s, m.a);
  for (std::size_t i = 0; i < 3; ++i) result.N[i] += lever[i];
  return result;
}

void add_wrench(DefinitionList& list, const std::string& name, Wrench& total, const Wrench& part,
                const NumberMatrix3& R, const Vector3ex& offset) {
  const Vector3ex F = named(list, "f" + name, times(R, part.F));
  const Vector3ex lever = cross(offset, F);
  total.F = total.F + F;
  total.N = total.N + times(R, part.N) + lever;
}

}  // namespace sinew

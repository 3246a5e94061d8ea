// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/composite_inertia.h"

namespace sinew {
namespace {

using GiNaC::ex;

const char* const axis_names[] = {"x", "y", "z", "1"};

PseudoInertia named(DefinitionList& list, const std::string& name, const PseudoInertia& J) {
  PseudoInertia result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j)
      result[i][j] = result[j][i] =
          sinew::named(list, name + axis_names[i] + axis_names[j], J[i][j]);
  return result;
}

}  // namespace

PseudoInertia to_expression(const NumberMatrix4& J) {
  PseudoInertia result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      result[i][j] = to_expression(Number(J(static_cast<int>(i), static_cast<int>(j))));
  return result;
}

PseudoInertia turned(DefinitionList& list, const std::string& name, const CosSin& angle,
                     const PseudoInertia& J) {
  const ex &a = J[0][0], &b = J[1][1], &h = J[0][1];
  const ex u = named(list, name + "u", (a - b) * angle.c - 2 * h * angle.s);
  const Vector3ex z = turn(angle, {J[0][2], J[1][2], J[2][2]});
  const Vector3ex s = turn(angle, {J[0][3], J[1][3], J[2][3]});
  PseudoInertia result = J;
  result[0][0] = b + angle.c * u;
  result[0][1] = h + angle.s * u;
  result[1][1] = a - angle.c * u;
  for (std::size_t i = 0; i < 2; ++i) {
    result[i][2] = z[i];
    result[i][3] = s[i];
  }
  return named(list, name, result);
}

PseudoInertia shifted(DefinitionList& list, const std::string& name, const Vector3ex& o,
                      const PseudoInertia& J) {
  PseudoInertia result = J;
  Vector3ex s_and_half;  // s + m o / 2, so that the products with o come out symmetric
  for (std::size_t i = 0; i < 3; ++i)
    s_and_half[i] = named(list, name + "h" + axis_names[i], J[i][3] + J[3][3] * o[i] / 2);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j)
      result[i][j] = J[i][j] + o[i] * s_and_half[j] + s_and_half[i] * o[j];
    result[i][3] = J[i][3] + J[3][3] * o[i];
  }
  return named(list, name, result);
}

PseudoInertia rotated(DefinitionList& list, const std::string& name, const NumberMatrix3& R,
                      const PseudoInertia& J) {
  PseudoInertia half = J;  // R J for the upper three rows
  for (std::size_t j = 0; j < 4; ++j) {
    const Vector3ex column =
        named(list, name + "r" + axis_names[j], times(R, {J[0][j], J[1][j], J[2][j]}));
    for (std::size_t i = 0; i < 3; ++i) half[i][j] = column[i];
  }
  PseudoInertia result = half;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3ex row = times(R, {half[i][0], half[i][1], half[i][2]});
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = row[j];
    result[3][i] = half[i][3];
  }
  return named(list, name, result);
}

PseudoInertia operator+(const PseudoInertia& a, const PseudoInertia& b) {
  PseudoInertia result;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) result[i][j] = a[i][j] + b[i][j];
  return result;
}

}  // namespace sinew

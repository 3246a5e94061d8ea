// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/spatial.h"

#include "symbolic/expressions/exact_number.h"

namespace sinew {

using GiNaC::ex;

ex named(DefinitionList& list, const std::string& name, const ex& value) {
  const ex opposite = -value;
  if (GiNaC::is_a<GiNaC::symbol>(opposite)) return value;
  return list.define(name, value);
}

Vector3ex named(DefinitionList& list, const std::string& name, const Vector3ex& value) {
  return {named(list, name + "x", value[0]), named(list, name + "y", value[1]),
          named(list, name + "z", value[2])};
}

ex to_expression(const Number& value) {
  return exact_number(static_cast<double>(value));
}

Vector3ex to_expression(const NumberVector3& value) {
  return {to_expression(value(0)), to_expression(value(1)), to_expression(value(2))};
}

Vector3ex zero_vector() {
  return {ex(0), ex(0), ex(0)};
}
Matrix3ex zero_matrix() {
  return {zero_vector(), zero_vector(), zero_vector()};
}

Vector3ex times(const NumberMatrix3& R, const Vector3ex& v) {
  Vector3ex result = zero_vector();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      result[i] += to_expression(R(static_cast<int>(i), static_cast<int>(j))) * v[j];
  return result;
}

Vector3ex transpose_times(const NumberMatrix3& R, const Vector3ex& v) {
  return times(NumberMatrix3(R.transpose()), v);
}

Vector3ex times(const Matrix3ex& A, const Vector3ex& v) {
  Vector3ex result = zero_vector();
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] += A[i][j] * v[j];
  return result;
}

Vector3ex turn(const CosSin& angle, const Vector3ex& v) {
  return {angle.c * v[0] - angle.s * v[1], angle.s * v[0] + angle.c * v[1], v[2]};
}

Vector3ex turn_back(const CosSin& angle, const Vector3ex& v) {
  return {angle.c * v[0] + angle.s * v[1], angle.c * v[1] - angle.s * v[0], v[2]};
}

}  // namespace sinew

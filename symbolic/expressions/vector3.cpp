// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/vector3.h"

#include "symbolic/expressions/exact_number.h"

namespace sinew {

Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector3 operator*(const GiNaC::ex& factor, const Vector3& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

GiNaC::ex dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 exact_vector(const Eigen::Vector3d& value) {
  return {exact_number(value[0]), exact_number(value[1]), exact_number(value[2])};
}

Vector3 define(DefinitionList& list, const std::string& name, const Vector3& value) {
  return {list.define(name + "_x", value[0]), list.define(name + "_y", value[1]),
          list.define(name + "_z", value[2])};
}

}  // namespace sinew

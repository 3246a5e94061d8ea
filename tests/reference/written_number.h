// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reference/scalar.h"

namespace sinew::reference {

/// The number a model file says: the shortest decimal that reads as `value`, in Scalar's precision.
///
/// A description's 0.042 means 42/1000 and not the double next to it, so with more digits than a
/// double's the two are different models. Rotations and axes are not written but computed.
template <class Scalar>
Scalar written_number(double value);
template <>
double written_number(double value);
template <>
long double written_number(double value);
template <>
Real50 written_number(double value);

template <class Scalar>
Vector3<Scalar> written_vector(const Eigen::Vector3d& values) {
  return values.unaryExpr([](double value) { return written_number<Scalar>(value); });
}
template <class Scalar>
Matrix3<Scalar> written_matrix(const Eigen::Matrix3d& values) {
  return values.unaryExpr([](double value) { return written_number<Scalar>(value); });
}

}  // namespace sinew::reference

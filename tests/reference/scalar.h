// SPDX-License-Identifier: GPL-3.0-or-later
// The number types the reference numerics are instantiated for.
#pragma once

#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <Eigen/Core>

namespace sinew::reference {

/// 50 decimal digits: rounding of this type is invisible next to 2^-53.
/// MPFR does the arithmetic, so neither its speed nor its results depend on how tests are compiled.
using Real50 = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
template <class Scalar>
using VectorX = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <class Scalar>
using MatrixX = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// Exact for double to wider types; rounds to nearest on the way back.
template <class To, class From>
MatrixX<To> convert(const MatrixX<From>& values) {
  return values.unaryExpr([](const From& value) { return static_cast<To>(value); });
}
template <class To, class From>
VectorX<To> convert(const VectorX<From>& values) {
  return values.unaryExpr([](const From& value) { return static_cast<To>(value); });
}

}  // namespace sinew::reference

// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that a derivation computes with: 50 digits, so that base parameters and frames carry no
// rounding of their own and are the same on every machine.
#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

namespace sinew {

using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                             boost::multiprecision::et_off>;
using NumberVector3 = Eigen::Matrix<Number, 3, 1>;
using NumberMatrix3 = Eigen::Matrix<Number, 3, 3>;
using NumberMatrix4 = Eigen::Matrix<Number, 4, 4>;

}  // namespace sinew

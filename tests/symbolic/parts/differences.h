// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives of a Function by differences, independent of any differentiation.
#pragma once

#include <cmath>
#include <vector>

#include "symbolic/expressions/evaluate_function.h"

namespace sinew_tests {

inline bool all_finite(const std::vector<double>& values) {
  for (const double value : values)
    if (!std::isfinite(value)) return false;
  return true;
}

/// Column `input` of the Jacobian of all outputs by central differences in 60 digits.
inline std::vector<double> difference(const sinew::Function& function,
                                      const std::vector<double>& at, std::size_t input) {
  std::vector<GiNaC::numeric> plus, minus;
  for (const double value : at) plus.push_back(sinew::binary_fraction(value));
  minus = plus;
  const GiNaC::numeric step = GiNaC::numeric(10).power(-15);
  plus[input] += step;
  minus[input] -= step;
  const auto high = sinew::evaluate_precisely(function, plus, 60);
  const auto low = sinew::evaluate_precisely(function, minus, 60);
  std::vector<double> result;
  for (std::size_t i = 0; i < high.size(); ++i)
    result.push_back(((high[i] - low[i]) / (2 * step)).to_double());
  return result;
}

}  // namespace sinew_tests

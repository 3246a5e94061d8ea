// SPDX-License-Identifier: GPL-3.0-or-later
// Numeric values of a derived function, before any code is made from it: what tests of the
// derivations use, and the reference for emitted code.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "generator/function.h"

namespace sinew {

/// All outputs one after the other, each row-major, from all inputs one after the other, in double.
/// Rounding depends on the order of terms, which GiNaC changes from run to run.
/// Throws std::invalid_argument if the number of inputs is wrong or an expression has no value.
std::vector<double> evaluate(const Function& function, const std::vector<double>& inputs);

/// The same with `digits` decimal digits; doubles count as exactly the binary fraction they are.
std::vector<GiNaC::numeric> evaluate_precisely(const Function& function,
                                               const std::vector<GiNaC::numeric>& inputs,
                                               int digits = 50);

/// evaluate_precisely's results, each rounded once: the same doubles on every run.
std::vector<double> rounded_values(const Function& function, const std::vector<double>& inputs);

/// The binary fraction `value` as an exact number.
GiNaC::numeric binary_fraction(double value);

}  // namespace sinew

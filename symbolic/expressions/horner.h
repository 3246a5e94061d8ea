// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "symbolic/expressions/definition_list.h"

namespace sinew {

/// Polynomial in Horner form, one definition a step; coefficients from the constant upwards.
GiNaC::ex horner(DefinitionList& list, const std::string& name,
                 const std::vector<double>& coefficients, const GiNaC::ex& variable);

/// Coefficients of the polynomial's derivative.
std::vector<double> derived_coefficients(const std::vector<double>& coefficients);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/horner.h"

#include "symbolic/expressions/exact_number.h"

namespace sinew {

GiNaC::ex horner(DefinitionList& list, const std::string& name,
                 const std::vector<double>& coefficients, const GiNaC::ex& variable) {
  GiNaC::ex value = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
    value = list.define(name, value * variable + exact_number(*c));
  return value;
}

std::vector<double> derived_coefficients(const std::vector<double>& coefficients) {
  std::vector<double> result;
  for (std::size_t i = 1; i < coefficients.size(); ++i)
    result.push_back(static_cast<double>(i) * coefficients[i]);
  return result;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives through a list of definitions by the chain rule, adding further definitions.
//
// Substituting the definitions first and differentiating the result would work on expressions of
// thousands of terms and lose every shared part. Derivatives of derivatives are taken the same way.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <vector>

#include "symbolic/expressions/definition_list.h"

namespace sinew {

/// Forward accumulation: d/d(variable) of anything written in a list's symbols.
class ForwardDerivative {
 public:
  /// Derivatives are appended to `list`, named <definition>_by_<suffix>. Inputs other than
  /// `variable` count as constants, unless they have been given a derivative by `seed`.
  ForwardDerivative(DefinitionList& list, const GiNaC::symbol& variable, std::string suffix);

  /// d(value)/d(variable), by definitions appended as needed.
  GiNaC::ex of(const GiNaC::ex& value);

  /// Declares the derivative of an input, for instance its rate, or of a definition whose
  /// derivative is known in a better form.
  void seed(const GiNaC::symbol& input, const GiNaC::ex& derivative);

 private:
  GiNaC::ex of_definition(std::size_t position);
  GiNaC::ex total(const GiNaC::ex& value, const GiNaC::ex& own);
  GiNaC::ex by_parts(const GiNaC::ex& value);

  DefinitionList& list_;
  std::string suffix_;
  std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> known_;
  std::vector<GiNaC::symbol> inputs_;
};

/// Jacobian of `values` with respect to `variables`, row-major, by forward accumulation: best for
/// few variables.
std::vector<GiNaC::ex> jacobian(DefinitionList& list, const std::vector<GiNaC::ex>& values,
                                const std::vector<GiNaC::symbol>& variables);

/// Gradient of one value by reverse accumulation: best for many variables. Adjoints are named
/// <prefix>_by_<definition>.
std::vector<GiNaC::ex> gradient(DefinitionList& list, const GiNaC::ex& value,
                                const std::vector<GiNaC::symbol>& variables,
                                const std::string& prefix);

/// Second derivatives of one value, row-major and symmetric: forward accumulation over forward.
std::vector<GiNaC::ex> hessian(DefinitionList& list, const GiNaC::ex& value,
                               const std::vector<GiNaC::symbol>& variables);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions as people read them: presentation MathML (MathML Core, what browsers draw), LaTeX
// (with amsmath) and plain text. The order of terms and factors does not depend on GiNaC's, which
// changes from run to run.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>

namespace sinew {

/// Other names for symbols, for instance {"load", "tau_load"}.
using MathNames = std::map<std::string, std::string>;

/// A symbol's name, without a <math> element round it. Greek names become letters, what follows an
/// underscore or a number at the end a subscript, q followed by d's gets as many dots; names of
/// several letters stay words: "gamma_1", "q20", "qdd", "level_change".
std::string mathml_name(const std::string& name);

/// A <math> element. Knows sums, products, fractions, powers, roots, the elementary functions, and
/// minimum, maximum, choose, clamped and magnitude of symbolic/expressions/piecewise.h; other
/// functions appear by their name.
std::string mathml(const GiNaC::ex& expression, const MathNames& names = {});

/// left = right as a <math display="block"> element. Long sums get a row for each term;
/// large subexpressions that come back are named u, v, w and told below.
std::string mathml_equation(const std::string& left, const GiNaC::ex& right,
                            const MathNames& names = {});

/// The same in LaTeX's mathematics mode; of an equation rows of an align* environment, long sums on
/// several, without the line end of the last one.
std::string latex_name(const std::string& name);
std::string latex(const GiNaC::ex& expression, const MathNames& names = {});
std::string latex_equation(const std::string& left, const GiNaC::ex& right,
                           const MathNames& names = {});

/// The same on one line of plain text: "a*x^2 + |qd|*min(b, c)", and for the equation
/// "effort = d*u, u = ...". ASCII as far as names are.
std::string plain_text(const GiNaC::ex& expression, const MathNames& names = {});
std::string plain_equation(const std::string& left, const GiNaC::ex& right,
                           const MathNames& names = {});

}  // namespace sinew

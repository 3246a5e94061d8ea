// SPDX-License-Identifier: GPL-3.0-or-later
// One walk through an expression that writes MathML, plain text and LaTeX side by side.
#pragma once

#include <string>
#include <vector>

#include "symbolic/notation/print_mathml.h"

namespace sinew {

/// How tightly the outermost operation binds; a looser one inside a tighter one needs brackets.
enum class Binding { sum, product, power, atom };

struct Typeset {
  std::string math, text;
  Binding binding = Binding::atom;
  bool word = false;  ///< begins or ends with a word: products need a visible dot
  std::string latex{};
};

/// A term of a sum without its sign.
struct SignedTerm {
  Typeset term;
  bool negative = false;
};

Typeset typeset(const GiNaC::ex& expression, const MathNames& names);

/// Terms of a sum in the order they are written; the expression itself where it is no sum.
std::vector<SignedTerm> terms_of(const GiNaC::ex& expression, const MathNames& names);

/// Brackets round what binds less tightly than `needed`.
Typeset bracketed(Typeset piece, Binding needed);

/// A function of symbolic/expressions/piecewise.h or an elementary one.
Typeset typeset_function(const GiNaC::function& function, const MathNames& names);

/// A symbol under its shown name.
Typeset typeset_symbol(const std::string& name, const MathNames& names);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/piecewise.h"
#include "symbolic/notation/typeset.h"

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

Typeset call(const std::string& name, const std::vector<ex>& arguments, const MathNames& names) {
  std::string math, text, latex;
  for (const ex& argument : arguments) {
    const Typeset piece = typeset(argument, names);
    math += (math.empty() ? "" : "<mo>,</mo>") + piece.math;
    text += (text.empty() ? "" : ", ") + piece.text;
    latex += (latex.empty() ? "" : ", ") + piece.latex;
  }
  return {"<mrow><mi>" + name + "</mi><mo>&#x2061;</mo><mrow><mo>(</mo>" + math +
              "<mo>)</mo></mrow></mrow>",
          name + "(" + text + ")", Binding::atom, name.size() > 1,
          "\\operatorname{" + name + "}\\left(" + latex + "\\right)"};
}

Typeset absolute(const ex& argument, const MathNames& names) {
  const Typeset inner = typeset(argument, names);
  return {"<mrow><mo form=\"prefix\" stretchy=\"true\">|</mo>" + inner.math +
              "<mo form=\"postfix\" stretchy=\"true\">|</mo></mrow>",
          "|" + inner.text + "|", Binding::atom, false, "\\left|" + inner.latex + "\\right|"};
}

Typeset exponential(const ex& argument, const MathNames& names) {
  const Typeset above = typeset(argument, names);
  return {"<msup><mi>e</mi>" + above.math + "</msup>", "exp(" + above.text + ")", Binding::power,
          false, "e^{" + above.latex + "}"};
}

/// condition >= 0 with what is negative or constant brought to the other side.
Typeset typeset_condition(const ex& condition, const MathNames& names) {
  ex constant = 0, rest = condition;
  if (is_a<GiNaC::add>(condition))
    for (const ex& term : condition)
      if (is_a<numeric>(term)) constant += term;
  rest -= constant;
  constant = -constant;
  const std::vector<SignedTerm> terms = terms_of(rest, names);
  bool at_most = true;
  for (const SignedTerm& term : terms) at_most = at_most && term.negative;
  if (at_most) {
    rest = -rest;
    constant = -constant;
  }
  const Typeset left = typeset(rest, names), right = typeset(constant, names);
  return {left.math + (at_most ? "<mo>≤</mo>" : "<mo>≥</mo>") + right.math,
          left.text + (at_most ? " <= " : " >= ") + right.text, Binding::sum, false,
          left.latex + (at_most ? " \\le " : " \\ge ") + right.latex};
}

std::string case_row(const std::string& value, const std::string& when) {
  return "<mtr><mtd style=\"text-align:left\">" + value + "</mtd><mtd style=\"text-align:left\">" +
         when + "</mtd></mtr>";
}

Typeset cases(const ex& condition, const ex& a, const ex& b, const MathNames& names) {
  if (a.is_equal(1) && b.is_equal(-1)) return call("sgn", {condition}, names);
  const Typeset yes = typeset(a, names), no = typeset(b, names);
  const Typeset when = typeset_condition(condition, names);
  return {"<mrow><mo form=\"prefix\" stretchy=\"true\">{</mo><mtable>" +
              case_row(yes.math, "<mtext>if&#xa0;</mtext>" + when.math) +
              case_row(no.math, "<mtext>otherwise</mtext>") + "</mtable></mrow>",
          "(" + yes.text + " if " + when.text + ", otherwise " + no.text + ")", Binding::atom,
          false,
          "\\begin{cases}" + yes.latex + " & \\text{if } " + when.latex + " \\\\ " + no.latex +
              " & \\text{otherwise}\\end{cases}"};
}

std::string shown_name(const std::string& name) {
  if (name == "minimum") return "min";
  if (name == "maximum") return "max";
  if (name == "log") return "ln";
  if (name == "csgn") return "sgn";
  return name;
}

}  // namespace

Typeset typeset_function(const GiNaC::function& function, const MathNames& names) {
  const std::string name = function.get_name();
  std::vector<ex> arguments;
  for (std::size_t i = 0; i < function.nops(); ++i) arguments.push_back(function.op(i));
  if (name == "exp") return exponential(arguments[0], names);
  if (name == "abs") return absolute(arguments[0], names);
  if (name == "choose") return cases(arguments[0], arguments[1], arguments[2], names);
  // magnitude() of symbolic/expressions/piecewise.h; of x and -x the one without a sign is shown.
  if (name == "maximum" && (arguments[0] + arguments[1]).is_zero())
    return absolute(terms_of(arguments[0], names).front().negative ? arguments[1] : arguments[0],
                    names);
  return call(shown_name(name), arguments, names);
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/notation/print_mathml.h"

#include <algorithm>

#include "symbolic/notation/typeset.h"

namespace sinew {
namespace {

using GiNaC::ex;

struct Equation {
  std::string left;
  ex right;
};

/// Whether giving the subexpression a name of its own makes the whole easier to read.
bool worth_a_name(const ex& e, int times, const MathNames& names) {
  constexpr std::size_t kLong = 14;
  const bool kind = GiNaC::is_a<GiNaC::function>(e);
  return kind && times > 1 && typeset(e, names).text.size() >= kLong;
}

using Counts = std::map<std::string, std::pair<int, ex>>;

void count_subexpressions(const ex& e, const MathNames& names, Counts& counts) {
  if (GiNaC::is_a<GiNaC::function>(e)) {
    auto& entry = counts[typeset(e, names).text];
    ++entry.first;
    entry.second = e;
  }
  for (const ex& operand : e) count_subexpressions(operand, names, counts);
}

/// The longest subexpression that comes back, 0 where there is none.
ex repeated(const ex& e, const MathNames& names) {
  Counts counts;
  count_subexpressions(e, names, counts);
  std::size_t longest = 0;
  ex result = 0;
  for (const auto& [text, entry] : counts) {
    if (text.size() <= longest || !worth_a_name(entry.second, entry.first, names)) continue;
    longest = text.size();
    result = entry.second;
  }
  return result;
}

/// Multiplied out where that is shorter.
struct Shortened : GiNaC::map_function {
  explicit Shortened(const MathNames& shown) : names(shown) {}
  ex operator()(const ex& e) override {
    const ex inner = e.nops() ? e.map(*this) : e;
    if (!GiNaC::is_a<GiNaC::add>(inner) && !GiNaC::is_a<GiNaC::mul>(inner)) return inner;
    const ex expanded = inner.expand();
    return typeset(expanded, names).text.size() < typeset(inner, names).text.size() ? expanded
                                                                                    : inner;
  }
  const MathNames& names;
};

bool uses_name(const ex& e, const std::string& name) {
  if (GiNaC::is_a<GiNaC::symbol>(e)) return GiNaC::ex_to<GiNaC::symbol>(e).get_name() == name;
  return std::any_of(e.begin(), e.end(), [&](const ex& x) { return uses_name(x, name); });
}

/// The equation, and below it the subexpressions that were given names.
std::vector<Equation> arranged(const std::string& left, const ex& right, const MathNames& names) {
  std::vector<Equation> equations = {{left, right}};
  for (const char* name : {"u", "v", "w"}) {
    if (uses_name(right, name)) continue;
    const ex again = repeated(equations[0].right, names);
    if (again.is_zero()) break;
    equations[0].right = equations[0].right.subs(again == GiNaC::symbol(name));
    equations.push_back({name, again});
  }
  Shortened shortened(names);
  for (Equation& equation : equations) equation.right = shortened(equation.right);
  return equations;
}

std::string cell(const std::string& content, const char* side) {
  return std::string("<mtd style=\"text-align:") + side + "\">" + content + "</mtd>";
}

std::string row(const std::string& left, const std::string& sign, const std::string& right) {
  return "<mtr>" + cell(left, "right") + cell("<mo>" + sign + "</mo>", "center") +
         cell(right, "left") + "</mtr>";
}

std::string rows_of(const Equation& equation, const MathNames& names) {
  constexpr std::size_t kLongLine = 34;
  const std::string left = mathml_name(equation.left);
  const Typeset whole = typeset(equation.right, names);
  const std::vector<SignedTerm> terms = terms_of(equation.right, names);
  if (whole.text.size() < kLongLine || terms.size() < 2) return row(left, "=", whole.math);
  std::string text;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const SignedTerm& term = terms[i];
    const std::string sign = i == 0 ? "=" : term.negative ? "−" : "+";
    text += row(
        i == 0 ? left : "", sign,
        i == 0 && term.negative ? "<mo form=\"prefix\">−</mo>" + term.term.math : term.term.math);
  }
  return text;
}

/// left &= right; a long sum goes on in further rows.
std::string latex_rows(const Equation& equation, const MathNames& names) {
  constexpr std::size_t kLongRow = 60;  // characters of plain text
  std::string rows = latex_name(equation.left) + " &= ";
  std::size_t length = 0;
  const std::vector<SignedTerm> terms = terms_of(equation.right, names);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto& [term, negative] = terms[i];
    const bool breaks = length > 0 && length + term.text.size() > kLongRow;
    if (breaks) rows += " \\\\\n&\\quad ";
    rows += (i == 0 ? (negative ? "-" : "") : negative ? " - " : " + ") + term.latex;
    length = (breaks ? 0 : length) + term.text.size();
  }
  return rows;
}

}  // namespace

std::string mathml(const ex& expression, const MathNames& names) {
  return "<math>" + typeset(expression, names).math + "</math>";
}

std::string mathml_equation(const std::string& left, const ex& right, const MathNames& names) {
  std::string rows;
  for (const Equation& equation : arranged(left, right, names)) rows += rows_of(equation, names);
  return "<math display=\"block\"><mtable displaystyle=\"true\">" + rows + "</mtable></math>";
}

std::string latex(const ex& expression, const MathNames& names) {
  return typeset(expression, names).latex;
}

std::string latex_equation(const std::string& left, const ex& right, const MathNames& names) {
  std::string text;
  for (const Equation& equation : arranged(left, right, names))
    text += (text.empty() ? "" : " \\\\\n") + latex_rows(equation, names);
  return text;
}

std::string plain_text(const ex& expression, const MathNames& names) {
  return typeset(expression, names).text;
}

std::string plain_equation(const std::string& left, const ex& right, const MathNames& names) {
  std::string text;
  for (const Equation& equation : arranged(left, right, names))
    text +=
        (text.empty() ? "" : ", ") + equation.left + " = " + typeset(equation.right, names).text;
  return text;
}

}  // namespace sinew

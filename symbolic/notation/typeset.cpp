// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/notation/typeset.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace sinew {
namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

/// Whether a comes before b, numbers inside compared by value: x2 before x10.
bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  while (i < a.size() && j < b.size()) {
    if (digit(a[i]) && digit(b[j])) {
      std::size_t m = i, n = j;
      while (m < a.size() && digit(a[m])) ++m;
      while (n < b.size() && digit(b[n])) ++n;
      if (m - i != n - j) return m - i < n - j;
      const int order = a.compare(i, m - i, b, j, n - j);
      if (order != 0) return order < 0;
      i = m;
      j = n;
      continue;
    }
    if (a[i] != b[j]) return a[i] < b[j];
    ++i;
    ++j;
  }
  return a.size() - i < b.size() - j;
}

std::string decimal(const numeric& number) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number.to_double(),
                                 std::chars_format::general, 6);
  return {buffer, end.ptr};
}

/// 1.5e-06 as people write it.
std::string latex_number(const std::string& text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  return text.substr(0, e) + " \\cdot 10^{" + std::to_string(std::stoi(text.substr(e + 1))) + "}";
}

/// A number that is not negative.
Typeset typeset_number(const numeric& number) {
  if (number.is_integer() || !number.is_rational()) {
    const std::string text = decimal(number);
    return {"<mn>" + text + "</mn>", text, Binding::atom, false, latex_number(text)};
  }
  const std::string top = decimal(number.numer()), bottom = decimal(number.denom());
  return {"<mfrac><mn>" + top + "</mn><mn>" + bottom + "</mn></mfrac>", top + "/" + bottom,
          Binding::product, false, "\\frac{" + top + "}{" + bottom + "}"};
}

/// Highest power of anything in a term, to write polynomials downwards.
int degree_of(const ex& e) {
  if (is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1)) && ex_to<numeric>(e.op(1)).is_integer())
    return ex_to<numeric>(e.op(1)).to_int();
  if (is_a<numeric>(e)) return 0;
  if (!is_a<GiNaC::mul>(e)) return 1;
  int degree = 0;
  for (const ex& factor : e) degree += degree_of(factor);
  return degree;
}

/// Whether the sum is a polynomial in one thing: 8 u^4 - 8 u^2 + 1.
bool is_univariate(const ex& sum) {
  ex variable = 0;
  const auto admits = [&](const ex& x) {
    const ex base = is_a<GiNaC::power>(x) ? x.op(0) : x;
    if (is_a<numeric>(base)) return true;
    if (variable.is_zero()) variable = base;
    return variable.is_equal(base);
  };
  return std::all_of(sum.begin(), sum.end(), [&](const ex& term) {
    return is_a<GiNaC::mul>(term) ? std::all_of(term.begin(), term.end(), admits) : admits(term);
  });
}

/// The sign is kept apart: GiNaC turns (a - b) round as its order of the day has it.
struct Factors {
  std::vector<ex> above, below;
  numeric number = 1;  ///< not negative
  bool negative = false;
};

void add_factor(const ex& factor, Factors& factors) {
  if (is_a<numeric>(factor)) {
    factors.number = factors.number * ex_to<numeric>(factor);
  } else if (is_a<GiNaC::power>(factor) && is_a<numeric>(factor.op(1)) &&
             ex_to<numeric>(factor.op(1)).is_negative()) {
    factors.below.push_back(pow(factor.op(0), -factor.op(1)));
  } else {
    factors.above.push_back(factor);
  }
}

/// Terms with a minus, less those with a plus.
int surplus_of_minus(const ex& sum, const MathNames& names) {
  int surplus = 0;
  for (const SignedTerm& term : terms_of(sum, names)) surplus += term.negative ? 1 : -1;
  return surplus;
}

/// Whether the term that comes first, signs aside, has a minus.
bool leads_with_minus(const ex& sum, const MathNames& names) {
  const bool falling = is_univariate(sum);
  SignedTerm first;
  int first_degree = 0;
  for (const ex& term : sum) {
    const SignedTerm shown = terms_of(term, names).front();
    const int degree = falling ? degree_of(term) : 0;
    const bool before = first.term.text.empty() || degree > first_degree ||
                        (degree == first_degree && natural_less(shown.term.text, first.term.text));
    if (!before) continue;
    first = shown;
    first_degree = degree;
  }
  return first.negative;
}

/// Turns sums round so that they have few minus signs, and the product as well where that is
/// possible.
void settle_signs(Factors& factors, const MathNames& names) {
  ex* even = nullptr;
  std::string even_text;
  for (ex& factor : factors.above) {
    if (!is_a<GiNaC::add>(factor)) continue;
    const int surplus = surplus_of_minus(factor, names);
    if (surplus > 0 || (surplus == 0 && leads_with_minus(factor, names))) {
      factor = -factor;
      factors.negative = !factors.negative;
    }
    const std::string text = typeset(factor, names).text;
    if (surplus != 0 || natural_less(text, even_text)) continue;
    even = &factor;
    even_text = text;
  }
  if (!factors.negative || even == nullptr) return;
  *even = -*even;
  factors.negative = false;
}

Factors factors_of(const ex& e, const MathNames& names) {
  Factors factors;
  if (is_a<GiNaC::mul>(e))
    for (const ex& factor : e) add_factor(factor, factors);
  else
    add_factor(e, factors);
  factors.negative = factors.number.is_negative();
  if (factors.negative) factors.number = -factors.number;
  settle_signs(factors, names);
  return factors;
}

/// Words first, then letters, functions after them, sums last.
int rank_of(const ex& e, const Typeset& shown) {
  const ex base = is_a<GiNaC::power>(e) ? e.op(0) : e;
  if (is_a<GiNaC::symbol>(base) || is_a<GiNaC::constant>(base)) return shown.word ? 0 : 1;
  return is_a<GiNaC::add>(base) ? 3 : 2;
}

std::vector<Typeset> ordered(const std::vector<ex>& factors, const MathNames& names) {
  std::vector<std::pair<int, Typeset>> pieces;
  for (const ex& factor : factors) {
    const Typeset shown = bracketed(typeset(factor, names), Binding::power);
    pieces.emplace_back(rank_of(factor, shown), shown);
  }
  std::sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : natural_less(a.second.text, b.second.text);
  });
  std::vector<Typeset> result;
  for (const auto& piece : pieces) result.push_back(piece.second);
  return result;
}

bool starts_with_digit(const std::string& text) {
  return !text.empty() && text.front() >= '0' && text.front() <= '9';
}

Typeset product_of(std::vector<Typeset> pieces) {
  Typeset result = pieces.front();
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const bool dot = result.word || pieces[i].word;
    result.math += (dot ? "<mo>⋅</mo>" : "<mo>&#x2062;</mo>") + pieces[i].math;
    result.text += "*" + pieces[i].text;
    result.latex +=
        (dot || starts_with_digit(pieces[i].latex) ? " \\cdot " : " ") + pieces[i].latex;
    result.word = pieces[i].word;
    result.binding = Binding::product;
  }
  if (pieces.size() > 1) result.math = "<mrow>" + result.math + "</mrow>";
  return result;
}

Typeset typeset_fraction(const Typeset& above, const Typeset& below) {
  return {"<mfrac>" + above.math + below.math + "</mfrac>",
          bracketed(above, Binding::product).text + "/" + bracketed(below, Binding::power).text,
          Binding::product, false, "\\frac{" + above.latex + "}{" + below.latex + "}"};
}

/// Without its sign.
Typeset typeset_factors(const Factors& factors, const MathNames& names) {
  const bool rational = factors.number.is_rational();
  const numeric top = rational ? factors.number.numer() : factors.number;
  const numeric bottom = rational ? factors.number.denom() : numeric(1);
  std::vector<Typeset> above = ordered(factors.above, names), below = ordered(factors.below, names);
  if (!top.is_equal(1) || above.empty()) above.insert(above.begin(), typeset_number(top));
  if (!bottom.is_equal(1)) below.insert(below.begin(), typeset_number(bottom));
  const Typeset numerator = product_of(above);
  return below.empty() ? numerator : typeset_fraction(numerator, product_of(below));
}

/// A term whose sign is still to be written.
SignedTerm signed_term(const ex& e, const MathNames& names) {
  if (is_a<numeric>(e)) {
    const numeric number = ex_to<numeric>(e);
    return {typeset_number(number.is_negative() ? -number : number), number.is_negative()};
  }
  if (!is_a<GiNaC::mul>(e)) return {typeset(e, names), false};
  const Factors factors = factors_of(e, names);
  return {typeset_factors(factors, names), factors.negative};
}

Typeset typeset_power(const ex& e, const MathNames& names) {
  const ex exponent = e.op(1);
  if (is_a<numeric>(exponent) && ex_to<numeric>(exponent).is_negative())
    return typeset_factors(factors_of(e, names), names);
  if (exponent.is_equal(numeric(1, 2))) {
    const Typeset inner = typeset(e.op(0), names);
    return {"<msqrt>" + inner.math + "</msqrt>", "sqrt(" + inner.text + ")", Binding::atom, false,
            "\\sqrt{" + inner.latex + "}"};
  }
  const Typeset base = bracketed(typeset(e.op(0), names), Binding::atom);
  const Typeset above = typeset(exponent, names);
  return {"<msup>" + base.math + above.math + "</msup>",
          base.text + "^" + bracketed(above, Binding::atom).text, Binding::power, base.word,
          "{" + base.latex + "}^{" + above.latex + "}"};
}

Typeset typeset_sum(const ex& e, const MathNames& names) {
  const std::vector<SignedTerm> terms = terms_of(e, names);
  Typeset result{"", "", Binding::sum, false};
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const bool minus = terms[i].negative;
    const std::string form = i == 0 ? "<mo form=\"prefix\">−</mo>" : "<mo>−</mo>";
    if (minus || i > 0) result.math += minus ? form : "<mo>+</mo>";
    if (minus || i > 0) result.text += i == 0 ? "-" : minus ? " - " : " + ";
    const Typeset& term = terms[i].term;
    result.math += term.math;
    result.text += term.text;
    result.latex += (i == 0 ? (minus ? "-" : "") : minus ? " - " : " + ") + term.latex;
  }
  result.math = "<mrow>" + result.math + "</mrow>";
  return result;
}

}  // namespace

std::vector<SignedTerm> terms_of(const ex& expression, const MathNames& names) {
  struct Entry {
    SignedTerm term;
    int degree;
  };
  std::vector<Entry> entries;
  const auto append = [&](const ex& term) {
    SignedTerm shown = signed_term(term, names);
    shown.term = bracketed(shown.term, Binding::product);
    entries.push_back({shown, degree_of(term)});
  };
  if (!is_a<GiNaC::add>(expression)) {
    append(expression);
  } else {
    for (const ex& term : expression) append(term);
    const bool falling = is_univariate(expression);
    std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
      if (falling && a.degree != b.degree) return a.degree > b.degree;
      if (!falling && a.term.negative != b.term.negative) return b.term.negative;
      return natural_less(a.term.term.text, b.term.term.text);
    });
    // Short sums look best with a positive term first: 1 - x.
    if (entries.size() == 2 && entries[0].term.negative && !entries[1].term.negative)
      std::swap(entries[0], entries[1]);
  }
  std::vector<SignedTerm> terms;
  for (const Entry& entry : entries) terms.push_back(entry.term);
  return terms;
}

Typeset bracketed(Typeset piece, Binding needed) {
  if (piece.binding >= needed) return piece;
  return {"<mrow><mo>(</mo>" + piece.math + "<mo>)</mo></mrow>", "(" + piece.text + ")",
          Binding::atom, false, "\\left(" + piece.latex + "\\right)"};
}

Typeset typeset(const ex& expression, const MathNames& names) {
  if (is_a<numeric>(expression) || is_a<GiNaC::mul>(expression)) {
    const SignedTerm shown = signed_term(expression, names);
    if (!shown.negative) return shown.term;
    const Typeset inner = bracketed(shown.term, Binding::product);
    return {"<mrow><mo form=\"prefix\">−</mo>" + inner.math + "</mrow>", "-" + inner.text,
            Binding::sum, false, "-" + inner.latex};
  }
  if (is_a<GiNaC::symbol>(expression))
    return typeset_symbol(ex_to<GiNaC::symbol>(expression).get_name(), names);
  if (is_a<GiNaC::add>(expression)) return typeset_sum(expression, names);
  if (is_a<GiNaC::power>(expression)) return typeset_power(expression, names);
  if (is_a<GiNaC::function>(expression))
    return typeset_function(ex_to<GiNaC::function>(expression), names);
  if (expression.is_equal(GiNaC::Pi)) return {"<mi>π</mi>", "pi", Binding::atom, false, "\\pi"};
  return {"<mtext>?</mtext>", "?", Binding::atom, false, "\\text{?}"};
}

}  // namespace sinew

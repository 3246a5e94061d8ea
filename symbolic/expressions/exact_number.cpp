// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/exact_number.h"

#include <cln/cln.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include "symbolic/expressions/working_digits.h"

namespace sinew {

GiNaC::numeric exact_number(double value) {
  if (!std::isfinite(value))
    throw std::invalid_argument("a model value must be finite, neither infinite nor not-a-number");
  char text[64];
  const auto end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::scientific).ptr;
  const std::string scientific(text, end);  // for instance -4.2e-02
  const std::size_t mark = scientific.find('e');
  int exponent = std::stoi(scientific.substr(mark + 1));
  std::string digits = scientific.substr(0, mark);
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return GiNaC::numeric(digits.c_str()) * GiNaC::numeric(10).power(exponent);
}

GiNaC::numeric rational_root(const GiNaC::numeric& square) {
  if (square.is_negative()) throw std::invalid_argument("a negative number has no real root");
  const GiNaC::numeric scale = GiNaC::numeric(10).power(60);
  // √(n/d) = √(n d)/d keeps the roots of perfect squares exact.
  const GiNaC::numeric below = square.denom();
  return GiNaC::isqrt(square.numer() * below * scale * scale) / (below * scale);
}

GiNaC::numeric rational_value(const GiNaC::ex& constant) {
  const WorkingDigits scope(65);
  const GiNaC::ex value = constant.evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(value) || !GiNaC::ex_to<GiNaC::numeric>(value).is_real())
    throw std::invalid_argument("expected a constant with a real value");
  const cln::cl_N number = GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N();
  return GiNaC::numeric(cln::cl_N(cln::rational(cln::the<cln::cl_R>(number))));
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "symbolic/expressions/piecewise.h"
#include "symbolic/notation/print_mathml.h"

using namespace sinew;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

namespace {
bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
}  // namespace

TEST_CASE("names become letters, dots and subscripts") {
  CHECK(mathml_name("gamma_1") == "<msub><mi>γ</mi><mn>1</mn></msub>");
  CHECK(mathml_name("q20") == "<msub><mi>q</mi><mn>20</mn></msub>");
  CHECK(mathml_name("qd") == "<mover><mi>q</mi><mo>˙</mo></mover>");
  CHECK(mathml_name("qdd_3") == "<msub><mover><mi>q</mi><mo>¨</mo></mover><mn>3</mn></msub>");
  CHECK(mathml_name("F_C") == "<msub><mi>F</mi><mi>C</mi></msub>");
  CHECK(mathml_name("tau_motor") == "<msub><mi>τ</mi><mi>motor</mi></msub>");
  CHECK(mathml_name("level_change") == "<mi>level\u00a0change</mi>");
  CHECK(mathml_name("degree_2") == "<msub><mi>degree</mi><mn>2</mn></msub>");
  CHECK(mathml_name("<&>") == "<mi>&lt;&amp;&gt;</mi>");
  CHECK(mathml_name("") == "<mi></mi>");
}

TEST_CASE("sums, products, fractions, powers and roots in plain text") {
  const symbol a("a"), b("b"), x("x"), k2("k2"), k10("k10");
  CHECK(plain_text(a - b) == "a - b");
  CHECK(plain_text(-a - b) == "-a - b");
  CHECK(plain_text(-2 * a * (x - b)) == "2*a*(b - x)");
  CHECK(plain_text(a * (b - x) * (k2 - k10)) == plain_text(a * (x - b) * (k10 - k2)));
  CHECK(plain_text(-a * (b - x)) == "a*(x - b)");
  CHECK(plain_text(a / (2 * b * x)) == "a/(2*b*x)");
  CHECK(plain_text(numeric(-3, 4) * a) == "-3*a/4");
  CHECK(plain_text(pow(a + b, 2)) == "(a + b)^2");
  CHECK(plain_text(sqrt(a)) == "sqrt(a)");
  CHECK(plain_text(1 / sqrt(a)) == "1/sqrt(a)");
  CHECK(plain_text(pow(a, -b)) == "a^(-b)");
  CHECK(plain_text(8 * pow(x, 4) - 8 * pow(x, 2) + 1) == "8*x^4 - 8*x^2 + 1");
  CHECK(plain_text(k10 * a + k2 * b) == "a*k10 + b*k2");
  CHECK(plain_text(0.25 * a) == "0.25*a");
  CHECK(plain_text(GiNaC::Pi * a) == "a*pi");
  CHECK(plain_text(ex(0)) == "0");
  CHECK(plain_text(ex(-2)) == "-2");
}

TEST_CASE("functions, with the piecewise ones in their usual shape") {
  const symbol x("x"), y("y"), a("a");
  CHECK(plain_text(a * GiNaC::atan(x / y)) == "a*atan(x/y)");
  CHECK(plain_text(GiNaC::exp(-pow(x, 2))) == "exp(-x^2)");
  CHECK(plain_text(magnitude(x)) == "|x|");
  CHECK(plain_text(magnitude(-x)) == "|x|");
  CHECK(plain_text(abs(x)) == "|x|");
  CHECK(plain_text(choose(x, 1, -1)) == "sgn(x)");
  CHECK(plain_text(clamped(x, -1, 1)) == "min(max(x, -1), 1)");
  CHECK(plain_text(choose(x - 2, a, y)) == "(a if x >= 2, otherwise y)");
  CHECK(plain_text(choose(-x, a, y)) == "(a if x <= 0, otherwise y)");
  CHECK(plain_text(choose(1 - x, a, y)) == "(a if x <= 1, otherwise y)");
  CHECK(contains(mathml(choose(x, a, y)), "<mtable>"));
  CHECK(contains(mathml(a / x), "<mfrac><mi>a</mi><mi>x</mi></mfrac>"));
  CHECK(contains(mathml(sqrt(x)), "<msqrt><mi>x</mi></msqrt>"));
}

TEST_CASE("other names can be given") {
  const symbol load("load");
  CHECK(mathml(load, {{"load", "tau_L"}}) == "<math><msub><mi>τ</mi><mi>L</mi></msub></math>");
}

TEST_CASE("a long equation has a row a term and names what comes back") {
  const symbol q("q"), middle("middle"), half("half_range"), one("degree_1"), two("degree_2"),
      three("degree_3");
  const ex u = clamped((q - middle) / half, -1, 1);
  const ex effort = one * u + two * (2 * pow(u, 2) - 1) + three * (2 * u * (2 * pow(u, 2) - 1) - u);
  CHECK(plain_equation("effort", effort) ==
        "effort = degree_1*u + degree_2*(2*u^2 - 1) + degree_3*(4*u^3 - 3*u), "
        "u = min(max((q - middle)/half_range, -1), 1)");
  const std::string math = mathml_equation("effort", effort);
  std::size_t rows = 0;
  for (std::size_t at = math.find("<mtr>"); at != std::string::npos;
       at = math.find("<mtr>", at + 1))
    ++rows;
  CHECK(rows == 4);
  const symbol taken("u");
  CHECK(contains(plain_equation("effort", effort + taken), ", v = min"));
}

TEST_CASE("the order does not depend on when symbols were made") {
  const auto text = [](bool backwards) {
    const symbol early(backwards ? "z" : "a"), late(backwards ? "a" : "z");
    const symbol a = backwards ? late : early, z = backwards ? early : late;
    return mathml(z * GiNaC::sin(a) + a * GiNaC::cos(z) + a * z + pow(z, 2) +
                  sqrt(a) * (a - z) * (1 - a * z));
  };
  CHECK(text(false) == text(true));
}

// SPDX-License-Identifier: GPL-3.0-or-later
// lowering_key [--ginac]: the lowered forms of what nine GiNaC operations give, and of a function
// whose definitions reappear inside sums. With --ginac: the same expressions as GiNaC prints them.
#include <cstdio>
#include <cstring>
#include <iostream>
#include <iterator>
#include <sstream>

#include "generator/dump.h"
#include "generator/lower.h"

using namespace sinew;
using GiNaC::ex;
using GiNaC::lst;
using GiNaC::matrix;
using GiNaC::symbol;

namespace {

struct Case {
  const char* name;
  ex value;
};

const symbol x("x"), y("y"), z("z"), w("w");

/// Denavit-Hartenberg-like transform: what the derivations multiply.
matrix turn(const ex& angle, const ex& length) {
  return matrix{{cos(angle), -sin(angle), length * cos(angle)},
                {sin(angle), cos(angle), length * sin(angle)},
                {0, 0, 1}};
}

std::vector<Case> cases() {
  const ex product = (x + y * cos(z)) * (z - w * sin(x)) * (y - 2 * w);
  // normal() of denominators with common factors is left out: GiNaC leaves them factored or
  // expanded as their order has it, so derivations may not use it.
  const ex fraction = x / (y + z) + (w - x) / (y - z);
  const ex energy = ex(turn(x, w) * turn(y, z) * matrix{{1}, {2}, {1}}).evalm();
  const matrix system{{x + 2, y, z}, {y, z + 3, x * y}, {z - w, x, w + 5}};
  const ex pose = ex_to<matrix>(energy)(0, 0) - ex_to<matrix>(energy)(1, 0);
  const matrix inverse = system.inverse();
  const ex solution = GiNaC::lsolve(lst{x * z + y * w == 1, x * w - y * z == cos(z)}, lst{x, y});
  return {{"diff", (product * sin(x * y) + pose).diff(x)},
          {"expand", product.expand()},
          {"collect", (product * product).expand().collect(y)},
          {"normal", fraction.normal()},
          {"factor", factor(((x - y) * (y + 2 * z) * (z - w) * (x - w)).expand())},
          {"subs", (product + fraction).subs(lst{x == sin(w - y), z == w - 3})},
          {"inverse", inverse(0, 2) - inverse(2, 1)},
          {"solve", solution.op(0).rhs() * solution.op(1).rhs()},
          {"det", system.determinant()}};
}

Function function_of(const Case& c) {
  Function function;
  function.name = c.name;
  function.inputs = {{"q", 4, 1, {x, y, z, w}, "", "", {}}};
  function.outputs = {{"r", 1, 1, {c.value}, "", ""}};
  return function;
}

/// d = x + y may stand for the start of another sum; which of the two is met first is GiNaC's
/// choice and must not show.
Function reappearing() {
  const symbol d("d"), e("e");
  Function function = function_of({"reappearing", 0});
  function.definitions = {{d, x + y}, {e, x * y}};
  function.outputs[0].values = {sin(x + y + z) * cos(z + d) + exp(z + d + w) * tanh(x + y + z + w) +
                                log(x * y * z) * atan(z * e)};
  return function;
}

}  // namespace

int main(int argc, char** argv) {
  const bool ginac = argc > 1 && std::strcmp(argv[1], "--ginac") == 0;
  std::ostringstream text;
  for (const Case& c : cases())
    if (ginac)
      text << c.name << ": " << c.value << "\n";
    else
      text << dump_text(lower(function_of(c)));
  if (!ginac) text << dump_text(lower(reappearing()));
  std::cout << text.str();
}

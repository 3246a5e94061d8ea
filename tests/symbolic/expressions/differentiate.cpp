// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/differentiate.h"

#include <catch2/catch.hpp>

#include <set>
#include <string>

#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/expressions/piecewise.h"

using namespace sinew;
using GiNaC::ex;
using GiNaC::symbol;

namespace {

/// A chain of definitions that uses every special case: root, fraction, case distinction.
struct Example {
  symbol x{"x"}, y{"y"};
  DefinitionList list;
  ex value;

  Example() {
    const ex sum = list.define("sum", GiNaC::sin(x) * y + x * x);
    const ex root = list.define("root", GiNaC::sqrt(1 + sum * sum));
    const ex fraction = list.define("fraction", (root + y) / (2 + sum * y * y));
    const ex limited = list.define("limited", maximum(fraction, x - 5));
    value = limited * root + GiNaC::exp(sum) * y;
  }

  /// The value with all definitions put in: what GiNaC can differentiate by itself.
  ex written_out(const ex& e) const {
    ex result = e;
    for (auto item = list.items().rbegin(); item != list.items().rend(); ++item)
      result = result.subs(item->symbol == item->value);
    return result;
  }

  double at(const ex& e) const {
    const ex number = written_out(e).subs(GiNaC::lst{x == ex(0.7), y == ex(-0.4)}).evalf();
    return GiNaC::ex_to<GiNaC::numeric>(number).to_double();
  }
};

}  // namespace

TEST_CASE("chain rule through definitions equals differentiating the whole", "[differentiate]") {
  Example e;
  const ex whole = e.written_out(e.value);
  const auto forward = jacobian(e.list, {e.value}, {e.x, e.y});
  const auto reverse = gradient(e.list, e.value, {e.x, e.y}, "adjoint");
  const auto second = hessian(e.list, e.value, {e.x, e.y});
  const double by_x = e.at(whole.diff(e.x)), by_y = e.at(whole.diff(e.y));
  CHECK(e.at(forward[0]) == Approx(by_x).epsilon(1e-14));
  CHECK(e.at(forward[1]) == Approx(by_y).epsilon(1e-14));
  CHECK(e.at(reverse[0]) == Approx(by_x).epsilon(1e-14));
  CHECK(e.at(reverse[1]) == Approx(by_y).epsilon(1e-14));
  CHECK(e.at(second[0]) == Approx(e.at(whole.diff(e.x, 2))).epsilon(1e-13));
  CHECK(e.at(second[1]) == Approx(e.at(whole.diff(e.x).diff(e.y))).epsilon(1e-13));
  CHECK(e.at(second[3]) == Approx(e.at(whole.diff(e.y, 2))).epsilon(1e-13));
  CHECK(second[1].is_equal(second[2]));
}

TEST_CASE("names of definitions stay apart and their order is fixed", "[differentiate]") {
  Example first, second;
  jacobian(first.list, {first.value}, {first.x, first.y});
  jacobian(second.list, {second.value}, {second.x, second.y});
  REQUIRE(first.list.items().size() == second.list.items().size());
  std::set<std::string> names;
  for (std::size_t i = 0; i < first.list.items().size(); ++i) {
    const std::string name = first.list.items()[i].symbol.get_name();
    CHECK(name == second.list.items()[i].symbol.get_name());
    CHECK(names.insert(name).second);
  }
}

TEST_CASE("evaluation says what is missing", "[evaluate]") {
  const symbol x("x"), stray("stray");
  Function function{"example", "", "", {{"x", 1, 1, {x}, "", "", {{0, 1}}}}, {}, {}};
  function.outputs.push_back({"out", 1, 1, {GiNaC::sqrt(x) + GiNaC::Pi}, "", ""});
  CHECK(evaluate(function, {4.0})[0] == Approx(2 + 3.14159265358979).epsilon(1e-14));
  CHECK_THROWS_AS(evaluate(function, {}), std::invalid_argument);
  CHECK_THROWS_AS(evaluate(function, {1.0, 2.0}), std::invalid_argument);
  function.outputs[0].values[0] = stray;
  CHECK_THROWS_WITH(evaluate(function, {1.0}), Catch::Contains("stray"));
}

TEST_CASE("precise evaluation carries the digits asked for", "[evaluate]") {
  const symbol x("x");
  Function function{"example", "", "", {{"x", 1, 1, {x}, "", "", {{0, 1}}}}, {}, {}};
  function.outputs.push_back(
      {"out", 1, 1, {GiNaC::pow(GiNaC::sin(x), 2) + GiNaC::pow(GiNaC::cos(x), 2) - 1}, "", ""});
  const GiNaC::numeric error = GiNaC::abs(evaluate_precisely(function, {GiNaC::numeric(1, 3)})[0]);
  CHECK(error < GiNaC::numeric(10).power(-48));
  const GiNaC::numeric rough =
      GiNaC::abs(evaluate_precisely(function, {GiNaC::numeric(1, 3)}, 17)[0]);
  CHECK(rough < GiNaC::numeric(10).power(-16));
}

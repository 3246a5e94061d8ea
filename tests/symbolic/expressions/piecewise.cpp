// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expressions/piecewise.h"

#include <catch2/catch.hpp>

#include "symbolic/expressions/exact_number.h"

using GiNaC::ex;
using sinew::choose;
using sinew::maximum;
using sinew::minimum;

TEST_CASE("piecewise functions evaluate on numbers and stay symbolic otherwise", "[piecewise]") {
  const GiNaC::symbol x("x"), y("y");
  CHECK(ex(minimum(ex(2), ex(3))).is_equal(2));
  CHECK(ex(maximum(ex(2), ex(3))).is_equal(3));
  CHECK(ex(choose(ex(0), x, y)).is_equal(x));
  CHECK(ex(choose(ex(-1), x, y)).is_equal(y));
  CHECK(ex(minimum(x, x)).is_equal(x));
  CHECK(GiNaC::is_a<GiNaC::function>(ex(minimum(x, y))));
  const GiNaC::exmap at{{x, GiNaC::numeric(5, 2)}, {y, GiNaC::numeric(7, 3)}};
  CHECK(ex(minimum(x, y)).subs(at).evalf().is_equal(ex(GiNaC::numeric(7, 3)).evalf()));
  CHECK(ex(maximum(x, y) * 2).subs(at).is_equal(5));
  CHECK(sinew::clamped(x, 0, 1).subs(at).is_equal(1));
  CHECK(sinew::magnitude(-x).subs(at).is_equal(GiNaC::numeric(5, 2)));
}

TEST_CASE("piecewise derivatives follow the side that is taken", "[piecewise]") {
  const GiNaC::symbol x("x");
  const auto slope = [&x](const ex& value, const ex& at) { return value.diff(x).subs(x == at); };
  const ex square = x * x;
  CHECK(slope(minimum(square, x), GiNaC::numeric(1, 2)).is_equal(1));
  CHECK(slope(minimum(square, x), 2).is_equal(1));
  CHECK(slope(minimum(x, square), GiNaC::numeric(1, 4)).is_equal(GiNaC::numeric(1, 2)));
  CHECK(slope(maximum(square, x), 2).is_equal(4));
  CHECK(slope(choose(x - 1, square, 3 * x), 2).is_equal(4));
  CHECK(slope(choose(x - 1, square, 3 * x), 0).is_equal(3));
  CHECK(slope(maximum(x, ex(3)), 1).is_equal(0));  // a clamped value does not move
}

TEST_CASE("a double's shortest decimal text becomes an exact fraction", "[exact_number]") {
  using GiNaC::numeric;
  CHECK(sinew::exact_number(0.042) == numeric(21, 500));
  CHECK(sinew::exact_number(-9.81) == numeric(-981, 100));
  CHECK(sinew::exact_number(2.0e-7) == numeric(1, 5000000));
  CHECK(sinew::exact_number(1.5e22) == numeric(15) * numeric(10).power(21));
  CHECK(sinew::exact_number(0.0).is_zero());
  CHECK(sinew::exact_number(6400.0) == numeric(6400));
  CHECK_FALSE(sinew::exact_number(0.1) == numeric(0.1));  // the binary fraction differs
  CHECK_THROWS_AS(sinew::exact_number(std::numeric_limits<double>::infinity()),
                  std::invalid_argument);
}

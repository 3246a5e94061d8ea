// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that end in every way there is, for planted_results.
#include <catch2/catch.hpp>

#include "tests/skip.h"

TEST_CASE("passes") {
  CHECK(true);
}

TEST_CASE("fails") {
  CHECK(false);
}

TEST_CASE("is skipped") {
  return sinew::test::skip("no <tool> & none like it");
}

TEST_CASE("is skipped in part") {
  sinew::test::skip("one of two");
  CHECK(true);
}

TEST_CASE("fails beside what is skipped") {
  sinew::test::skip("one of two");
  CHECK(false);
}

TEST_CASE("fails as often as a skipped test's status") {
  for (int i = 0; i < 77; ++i) CHECK(false);
}

TEST_CASE("checks nothing") {}

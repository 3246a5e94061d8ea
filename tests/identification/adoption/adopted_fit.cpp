// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/adopted_fit.h"

#include <catch2/catch.hpp>

using namespace sinew::diagnosis;

// Seen red with the candidates that a name stands for besides left out.
TEST_CASE("a candidate's cause is the one that it is told by, or that stands for it, too") {
  Verdict verdict;
  verdict.causes.resize(2);
  verdict.causes[0].candidate = 4;
  verdict.causes[1].candidate = 0;
  verdict.causes[1].also = {1};
  CHECK(cause_of(verdict, 0) == 1);
  CHECK(cause_of(verdict, 1) == 1);
  CHECK(cause_of(verdict, 4) == 0);
  CHECK(cause_of(verdict, 2) == -1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/body_limits.h"

#include <catch2/catch.hpp>

using Eigen::VectorXd;
using sinew::diagnosis::is_body;

namespace {

/// Mass, first moments, moments of inertia xx, yy, zz, xy, xz, yz.
VectorXd ten(std::initializer_list<double> values) {
  VectorXd all = VectorXd::Zero(10);
  Eigen::Index k = 0;
  for (const double value : values) all(k++) = value;
  return all;
}

}  // namespace

TEST_CASE("a payload has the moments of a body within reach") {
  const VectorXd known = VectorXd::Constant(10, 1e-4);
  const double reach = 1.0;
  CHECK(is_body(ten({0.2, 0.05, 0.0, 0.02, 0.01, 0.01, 0.02}), known, reach));
  // A first moment without mass; a moment of inertia without; a negative one.
  CHECK_FALSE(is_body(ten({0.0, 0.05}), known, reach));
  CHECK_FALSE(is_body(ten({0.0, 0.0, 0.0, 0.0, 0.01}), known, reach));
  CHECK_FALSE(is_body(ten({0.2, 0.0, 0.0, 0.0, -0.01}), known, reach));
  // By chance only, or said by nothing in the logs.
  CHECK(is_body(ten({0.0, 1e-4, 0.0, 0.0, -1e-4}), known, reach));
  VectorXd massless = known;
  massless(0) = 0.0;
  CHECK(is_body(ten({0.0, 0.05}), massless, reach));
  // Mass and first moments alone, as values of a model.
  CHECK_FALSE(is_body(ten({0.01, 0.05}).head(4), known.head(4), reach));
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/signals.h"

#include <catch2/catch.hpp>

using sinew::diagnosis::Signals;

// Seen red with copies that write what they share.
TEST_CASE("a copy shares signals until it writes one") {
  Signals first;
  first["speed"] = Eigen::MatrixXd::Constant(3, 2, 1.0);
  first["force"] = Eigen::MatrixXd::Constant(3, 1, 5.0);
  Signals copy = first;
  CHECK(copy.find("speed") == first.find("speed"));
  copy["speed"](1, 0) = 7.0;
  CHECK(first.at("speed")(1, 0) == 1.0);
  CHECK(copy.at("speed")(1, 0) == 7.0);
  CHECK(copy.at("speed")(2, 1) == 1.0);
  CHECK(copy.find("force") == first.find("force"));
  first["force"] = Eigen::MatrixXd::Zero(1, 1);
  CHECK(copy.at("force").rows() == 3);
  CHECK(copy.find("way") == nullptr);
  CHECK(copy.count("force") == 1);
  CHECK_THROWS_AS(copy.at("way"), std::out_of_range);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/numbers.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <clocale>
#include <limits>

#include "tests/skip.h"

using namespace sinew::diagnosis;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// With ordinary blanks.
std::string plain(std::string text) {
  const std::string space = "\u00a0";
  for (std::size_t at = text.find(space); at != std::string::npos; at = text.find(space))
    text.replace(at, space.size(), " ");
  return text;
}

}  // namespace

TEST_CASE("numbers have the digits a person reads") {
  CHECK(shown_number(0.0) == "0");
  CHECK(shown_number(12.3456) == "12.3");
  CHECK(shown_number(-0.00123456) == "−0.00123");
  CHECK(shown_number(123456.0) == "123456");
  CHECK(shown_number(9.996, 3) == "10.0");
  CHECK(shown_number(1.5e-7) == "1.50×10⁻⁷");
  CHECK(shown_number(kNaN) == "–");
  CHECK(shown_number(-std::numeric_limits<double>::infinity()) == "−∞");
}

TEST_CASE("units are set as in a book") {
  CHECK(shown_unit("N*m*s/rad") == "N·m·s/rad");
  CHECK(shown_unit("N m") == "N·m");
  CHECK(shown_unit("kg*m^2") == "kg·m²");
  CHECK(shown_unit("s^-1") == "s⁻¹");
  CHECK(shown_unit("1") == "");
  CHECK(shown_unit("^") == "^");
}

TEST_CASE("quantities take the natural prefix") {
  CHECK(plain(shown_quantity(0.00081, "s")) == "0.810 ms");
  CHECK(plain(shown_quantity(0.0312, "m/s")) == "31.2 mm/s");
  CHECK(plain(shown_quantity(0.5, "N*m")) == "0.500 N·m");
  CHECK(plain(shown_quantity(-2.5e-6, "m")) == "−2.50 µm");
  CHECK(plain(shown_quantity(25000.0, "N")) == "25.0 kN");
  CHECK(plain(shown_quantity(25000.0, "m")) == "25000 m");
  CHECK(plain(shown_quantity(3e-5, "kg*m^2")) == "3.00×10⁻⁵ kg·m²");
  CHECK(plain(shown_quantity(0.02, "m^2")) == "0.0200 m²");
  CHECK(plain(shown_quantity(0.02, "1")) == "0.0200");
}

TEST_CASE("axes take a unit in which their values need few digits") {
  const auto shown = [](double largest, const char* unit) {
    const AxisUnit axis = axis_unit(largest, unit);
    return fmt::format("{:.3g} {}", largest * axis.factor, axis.unit);
  };
  CHECK(shown(24.0, "s") == "24 s");
  CHECK(shown(1.5e-5, "N*m") == "15 µN·m");
  CHECK(shown(2e-5, "kg*m^2") == "2 10⁻⁵ kg·m²");
  CHECK(shown(123456.0, "1") == "1.23 10⁵");
  CHECK(shown(0.0, "m") == "0 m");
}

TEST_CASE("an estimate and its error share prefix and digits") {
  CHECK(plain(shown_estimate(12.3456, 0.31, "N")) == "12.35 ± 0.31 N");
  CHECK(plain(shown_estimate(0.00081, 0.00004, "s")) == "0.810 ± 0.040 ms");
  CHECK(plain(shown_estimate(-8.614, 0.52, "N*s/m")) == "−8.61 ± 0.52 N·s/m");
  CHECK(plain(shown_estimate(3.1e-5, 2e-6, "kg*m^2")) == "(3.10 ± 0.20)×10⁻⁵ kg·m²");
  CHECK(plain(shown_estimate(0.001, 0.5, "N")) == "0.00 ± 0.50 N");
  CHECK(plain(shown_estimate(2.5, 0.0, "N")) == "2.500 N");
  CHECK(plain(shown_estimate(2.5, kNaN, "N")) == "2.500 N");
  CHECK(plain(shown_estimate(kNaN, 1.0, "N")) == "– N");
}

TEST_CASE("shares and confidences promise no more than they hold") {
  CHECK(plain(shown_share(0.0408)) == "4.1 %");
  CHECK(plain(shown_share(0.712)) == "71 %");
  CHECK(plain(shown_share(0.9984)) == "99.8 %");
  CHECK(plain(shown_share(0.00001)) == "0.00 %");
  CHECK(plain(shown_share(-0.32)) == "−32 %");
  CHECK(plain(shown_share(kNaN)) == "–");
  CHECK(plain(shown_percent(0.0408)) == "4.08 %");
  CHECK(plain(shown_interval({0.7, 0.661, 0.754})) == "66 to 75 %");
  CHECK(plain(shown_confidence(0.979)) == "97 %");
  CHECK(plain(shown_confidence(0.9999)) == "> 99 %");
  CHECK(plain(shown_confidence(1.0)) == "> 99 %");
  CHECK(plain(shown_duration(4.2)) == "4.2 s");
  CHECK(plain(shown_duration(3600.0)) == "60 min");
}

TEST_CASE("numbers do not obey the locale") {
  const char* changed = std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
  CHECK(shown_number(1.5) == "1.50");
  std::setlocale(LC_NUMERIC, "C");
  if (!changed) sinew::test::skip("the locale de_DE.UTF-8 is not installed");
}

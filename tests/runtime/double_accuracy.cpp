// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the double functions against MPFR. The limits are those of docs/trigonometry.md.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "angles.h"
#include "exact_value.h"
#include "sinew_math.h"

namespace {

using sinew::angles_within;
using sinew::ulp_error;

constexpr double pi = std::numbers::pi;

struct Errors {
  double sine = 0, cosine = 0;
};

template <class Sincos>
Errors worst_sincos(Sincos sincos, double limit) {
  Errors worst;
  for (const double x : angles_within(limit, 60000)) {
    double s, c;
    sincos(x, &s, &c);
    worst.sine = std::max(worst.sine, ulp_error(s, mpfr_sin, x));
    worst.cosine = std::max(worst.cosine, ulp_error(c, mpfr_cos, x));
  }
  return worst;
}

double worst(double (*computed)(double), sinew::ExactFunction exact, double low, double high) {
  double result = 0;
  sinew::Uniform uniform(12345);
  for (int i = 0; i < 100000; ++i) {
    const double x = uniform(low, high);
    result = std::max(result, ulp_error(computed(x), exact, x));
  }
  for (double x : angles_within(std::max(std::fabs(low), std::fabs(high)), 1000))
    if (x >= low && x <= high) result = std::max(result, ulp_error(computed(x), exact, x));
  return result;
}

}  // namespace

TEST_CASE("sine and cosine are within one ulp up to 800 rad") {
  for (const double limit : {pi / 4, pi, 64 * pi, 800.0}) {
    const Errors errors = worst_sincos(sinew_sincos, limit);
    UNSCOPED_INFO("|x| <= " << limit << ": sin " << errors.sine << ", cos " << errors.cosine);
    CHECK(errors.sine <= 0.82);
    CHECK(errors.cosine <= 0.82);
  }
}

TEST_CASE("sine and cosine of large angles are within one ulp up to 2^20") {
  const Errors errors = worst_sincos(sinew_sincos_wide, 0x1p20);
  CHECK(errors.sine <= 0.82);
  CHECK(errors.cosine <= 0.82);
}

TEST_CASE("beyond its range sincos is wrong, and this measurement sees it") {
  CHECK(worst_sincos(sinew_sincos, 0x1p20).sine > 1e6);
}

TEST_CASE("inverse functions are within one ulp") {
  CHECK(worst(sinew_atan, mpfr_atan, -3, 3) <= 0.72);
  CHECK(worst(sinew_atan, mpfr_atan, -1e9, 1e9) <= 0.72);
  CHECK(worst(sinew_asin, mpfr_asin, -1, 1) <= 0.72);
  CHECK(worst(sinew_acos, mpfr_acos, -1, 1) <= 0.72);
  for (int k = 1; k < 52; ++k) {  // near the ends, where asin and acos have vertical tangents
    const double x = 1 - std::ldexp(1.0, -k);
    CHECK(ulp_error(sinew_acos(x), mpfr_acos, x) <= 0.72);
    CHECK(ulp_error(sinew_acos(-x), mpfr_acos, -x) <= 0.72);
    CHECK(ulp_error(sinew_asin(x), mpfr_asin, x) <= 0.72);
  }
}

TEST_CASE("atan2 is within one ulp in every direction and for lengths from 1e-300 to 1e300") {
  sinew::Uniform uniform(99);
  double largest = 0;
  for (int i = 0; i < 100000; ++i) {
    const double angle = uniform(-pi, pi), length = std::pow(10.0, uniform(-300, 300));
    const double y = length * std::sin(angle);
    const double x = i % 2 == 0 ? length * std::cos(angle) : uniform(-1, 1) * length;
    largest = std::max(largest, ulp_error(sinew_atan2(y, x), mpfr_atan2, y, x));
  }
  INFO("largest error " << largest);
  CHECK(largest <= 0.72);
}

TEST_CASE("exp and log are within one ulp, tanh within three") {
  CHECK(worst(sinew_exp, mpfr_exp, -708, 708) <= 1.0);
  CHECK(worst(sinew_exp, mpfr_exp, -1, 1) <= 1.0);
  CHECK(worst(sinew_log, mpfr_log, 1e-3, 3) <= 1.0);
  CHECK(worst(sinew_log, mpfr_log, 1e-300, 1e300) <= 1.0);
  CHECK(worst(sinew_tanh, mpfr_tanh, -20, 20) <= 3.0);
  CHECK(worst(sinew_tanh, mpfr_tanh, -1, 1) <= 3.0);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The exhaustive program with a stride: a sample of each float function's whole range, every time.
#include <catch2/catch.hpp>
#include <cmath>

#include "angles.h"
#include "sinew_math.h"
#include "ulp.h"

namespace {

using sinew::ulp_error;

double worst(float (*computed)(float), double (*exact)(double), float low, float high) {
  double result = 0;
  for (const float x : sinew::angles_within(std::max(std::fabs(low), std::fabs(high)), 200000))
    if (x >= low && x <= high)
      result = std::max(result, ulp_error(computed(x), exact(static_cast<double>(x))));
  return result;
}

float sine(float x) {
  float s, c;
  sinew_sincosf(x, &s, &c);
  return s;
}

float cosine(float x) {
  float s, c;
  sinew_sincosf(x, &s, &c);
  return c;
}

}  // namespace

TEST_CASE("float functions are within one ulp, tanh within three") {
  CHECK(worst(sine, std::sin, -800, 800) <= 0.9);
  CHECK(worst(cosine, std::cos, -800, 800) <= 0.9);
  CHECK(worst(sinew_asinf, std::asin, -1, 1) <= 0.9);
  CHECK(worst(sinew_acosf, std::acos, -1, 1) <= 0.9);
  CHECK(worst(sinew_atanf, std::atan, -30, 30) <= 0.9);
  CHECK(worst(sinew_expf, std::exp, -87, 87) <= 1.0);
  CHECK(worst(sinew_logf, std::log, 1e-30F, 80) <= 1.0);
  CHECK(worst(sinew_tanhf, std::tanh, -10, 10) <= 3.0);
}

TEST_CASE("float atan2 is within one ulp") {
  sinew::Uniform uniform(7);
  double largest = 0;
  for (int i = 0; i < 1000000; ++i) {
    const auto y = static_cast<float>(uniform(-1, 1)), x = static_cast<float>(uniform(-1, 1));
    const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
    largest = std::max(largest, ulp_error(sinew_atan2f(y, x), exact));
  }
  CHECK(largest <= 0.9);
}

TEST_CASE("an error of more than one unit is seen") {
  const auto off = [](float x) { return std::nextafter(std::nextafter(sine(x), 2.0F), 2.0F); };
  CHECK(worst(off, std::sin, -3, 3) > 1.0);
}

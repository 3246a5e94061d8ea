// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every input: finite results, symmetry, the same bits in every lane.
#include <bit>
#include <catch2/catch.hpp>
#include <cstdint>
#include <limits>
#include <vector>

#include "angles.h"
#include "sinew_math.h"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double quiet = std::numeric_limits<double>::quiet_NaN();

// Bit patterns of every kind: all exponents with both signs, and everything that is not a number.
std::vector<double> every_kind_of_double() {
  std::vector<double> result{quiet, -quiet, infinity, -infinity, 0.0, -0.0};
  for (std::uint64_t exponent = 0; exponent < 2048; ++exponent)
    for (const std::uint64_t rest : {std::uint64_t{0}, 0x000fffffffffffffU, 0x0005a5a5a5a5a5a5U})
      for (const std::uint64_t sign : {std::uint64_t{0}, 0x8000000000000000U})
        result.push_back(std::bit_cast<double>(sign | exponent << 52 | rest));
  return result;
}

std::vector<float> every_kind_of_float() {
  std::vector<float> result;
  for (std::uint32_t high = 0; high < 0x10000U; high += 3)
    result.push_back(std::bit_cast<float>(high << 16 | (high * 40503U & 0xffffU)));
  result.insert(result.end(), {-0.0F, static_cast<float>(infinity), -static_cast<float>(infinity)});
  return result;
}

std::uint64_t bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}
std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

}  // namespace

TEST_CASE("every double gives finite doubles") {
  int wrong = 0;
  double s, c;
  const auto check = [&](double value, double limit) {
    if (!(std::fabs(value) <= limit)) ++wrong;
  };
  for (const double x : every_kind_of_double()) {
    sinew_sincos(x, &s, &c);
    check(s, 1.001), check(c, 1.001);
    sinew_sincos_wide(x, &s, &c);
    check(s, 1.001), check(c, 1.001);
    check(sinew_atan(x), 1.5708), check(sinew_asin(x), 1.5708), check(sinew_acos(x), 3.1416);
    check(sinew_exp(x), 1e308), check(sinew_log(x), 710), check(sinew_tanh(x), 1);
    check(sinew_sqrt(x), 1.4e154), check(sinew_finite(x), std::numeric_limits<double>::max());
    for (const double y : {1.0, -0.0, 1e-320, -infinity, quiet}) {
      check(sinew_atan2(y, x), 3.1416), check(sinew_atan2(x, y), 3.1416);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("every float gives finite floats") {
  int wrong = 0;
  float s, c;
  const auto check = [&](float value, float limit) {
    if (!(std::fabs(value) <= limit)) ++wrong;
  };
  for (const float x : every_kind_of_float()) {
    sinew_sincosf(x, &s, &c);
    check(s, 1.001F), check(c, 1.001F);
    sinew_sincos_widef(x, &s, &c);
    check(s, 1.001F), check(c, 1.001F);
    check(sinew_atanf(x), 1.5708F), check(sinew_asinf(x), 1.5708F), check(sinew_acosf(x), 3.1416F);
    check(sinew_expf(x), 3e38F), check(sinew_logf(x), 89), check(sinew_tanhf(x), 1);
    check(sinew_sqrtf(x), 1.9e19F), check(sinew_finitef(x), std::numeric_limits<float>::max());
    for (const float y : {1.0F, -0.0F, 1e-42F, static_cast<float>(quiet)}) {
      check(sinew_atan2f(y, x), 3.1416F), check(sinew_atan2f(x, y), 3.1416F);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("sine is odd and cosine is even, exactly") {
  int wrong = 0;
  for (const double x : sinew::angles_within(800.0, 20000)) {
    double s, c, s_negative, c_negative;
    sinew_sincos(x, &s, &c);
    sinew_sincos(-x, &s_negative, &c_negative);
    if (s != -s_negative || c != c_negative) ++wrong;
    if (sinew_atan(-x) != -sinew_atan(x) || sinew_tanh(-x) != -sinew_tanh(x)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("two and four lanes give the bits of one lane") {
  int wrong = 0;
  std::vector<double> x = sinew::angles_within(800.0, 20000);
  for (const double special : every_kind_of_double()) x.push_back(special);
  for (std::size_t i = 0; i + 4 <= x.size(); ++i) {
    double s, c, s2[2], c2[2], s4[4], c4[4];
    sinew_sincos2(&x[i], s2, c2);
    sinew_sincos4(&x[i], s4, c4);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      sinew_sincos(x[i + lane], &s, &c);
      if (bits(s) != bits(s4[lane]) || bits(c) != bits(c4[lane])) ++wrong;
      if (lane < 2 && (bits(s) != bits(s2[lane]) || bits(c) != bits(c2[lane]))) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("two and four float lanes give the bits of one lane") {
  int wrong = 0;
  const std::vector<float> x = every_kind_of_float();
  for (std::size_t i = 0; i + 4 <= x.size(); ++i) {
    float s, c, s2[2], c2[2], s4[4], c4[4];
    sinew_sincos2f(&x[i], s2, c2);
    sinew_sincos4f(&x[i], s4, c4);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      sinew_sincosf(x[i + lane], &s, &c);
      if (bits(s) != bits(s4[lane]) || bits(c) != bits(c4[lane])) ++wrong;
      if (lane < 2 && (bits(s) != bits(s2[lane]) || bits(c) != bits(c2[lane]))) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("selection treats zero as not negative and NaN as not chosen") {
  CHECK(sinew_choose(0.0, 1.0, 2.0) == 1.0);
  CHECK(sinew_choose(-0.0, 1.0, 2.0) == 1.0);
  CHECK(sinew_choose(5e-324, 1.0, 2.0) == 1.0);
  CHECK(sinew_choose(infinity, 1.0, 2.0) == 1.0);
  CHECK(sinew_choose(-5e-324, 1.0, 2.0) == 2.0);
  CHECK(sinew_choose(-infinity, 1.0, 2.0) == 2.0);
  CHECK(sinew_choose(quiet, 1.0, 2.0) == 2.0);
  CHECK(sinew_choose(-quiet, 1.0, 2.0) == 2.0);
  CHECK(sinew_choosef(-0.0F, 1.0F, 2.0F) == 1.0F);
  CHECK(sinew_choosef(-static_cast<float>(quiet), 1.0F, 2.0F) == 2.0F);
  CHECK(sinew_min(1.0, 2.0) == 1.0);
  CHECK(sinew_min(quiet, 2.0) == 2.0);
  CHECK(sinew_max(-1.0, -infinity) == -1.0);
  CHECK(sinew_maxf(1.0F, 3.0F) == 3.0F);
  CHECK(sinew_abs(-2.5) == 2.5);
  CHECK(sinew_absf(-2.5F) == 2.5F);
  for (const double x : {0.0, -0.0, infinity, -infinity, quiet, -quiet}) {
    CHECK_FALSE(std::signbit(sinew_abs(x)));
    CHECK_FALSE(std::signbit(sinew_absf(static_cast<float>(x))));
  }
}

TEST_CASE("square roots are those of the C library, and zero where there is none") {
  int wrong = 0;
  for (const double x : every_kind_of_double()) {
    const double expected = x > 0 && x < infinity ? std::sqrt(x) : 0;
    if (sinew_sqrt(x) != expected) ++wrong;
  }
  CHECK(wrong == 0);
  CHECK(sinew_sqrtf(2.0F) == std::sqrt(2.0F));
  CHECK(sinew_sqrtf(-1.0F) == 0.0F);
}

TEST_CASE("inputs outside the domain count as its end") {
  CHECK(sinew_acos(1.5) == 0.0);
  CHECK(sinew_acos(-1.5) == sinew_acos(-1.0));
  CHECK(sinew_asin(quiet) == sinew_asin(1.0));
  CHECK(sinew_exp(1e5) == sinew_exp(708.0));
  CHECK(sinew_exp(-infinity) == sinew_exp(-708.0));
  CHECK(sinew_log(0.0) == sinew_log(0x1p-1022));
  CHECK(sinew_log(-3.0) == sinew_log(0x1p-1022));
  CHECK(sinew_atan2(0.0, 0.0) == 0.0);
  CHECK(sinew_atan2(infinity, infinity) == sinew_atan2(1.0, 1.0));
  CHECK(sinew_finite(infinity) == 0.0);
  CHECK(sinew_finite(3.0) == 3.0);
}

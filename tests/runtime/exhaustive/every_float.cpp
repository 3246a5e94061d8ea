// SPDX-License-Identifier: GPL-3.0-or-later
// Every float of its range through every float function of one argument.
//
// The truth is the double function of the same name: its error, measured against MPFR by
// double_accuracy.cpp, is below 2^-28 ulp of a float, and unlike the C library's it is vectorised,
// which makes ten thousand million floats a matter of a minute.
//
// usage: every_float [stride]   stride 1 (the default) leaves none out
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string_view>
#include <thread>
#include <vector>

#include "sinew_math.h"

namespace {

constexpr std::size_t block = 1024;
using Floats = std::array<float, block>;
using Doubles = std::array<double, block>;

struct Worst {
  double error = 0;
  float at = 0;

  void take(const Worst& other) {
    if (!(other.error <= error)) *this = other;
  }
};

// Sine and cosine come together; functions of one result leave the second alone.
struct Function {
  int results;
  void (*computed)(const Floats&, Floats&, Floats&);
  void (*exact)(const Floats&, Doubles&, Doubles&);
};

template <void (*computed)(float, float*, float*), void (*exact)(double, double*, double*)>
constexpr Function pair{2,
                        [](const Floats& x, Floats& s, Floats& c) {
                          for (std::size_t i = 0; i < block; ++i) computed(x[i], &s[i], &c[i]);
                        },
                        [](const Floats& x, Doubles& s, Doubles& c) {
                          for (std::size_t i = 0; i < block; ++i)
                            exact(static_cast<double>(x[i]), &s[i], &c[i]);
                        }};

template <float (*computed)(float), double (*exact)(double)>
constexpr Function single{1,
                          [](const Floats& x, Floats& y, Floats&) {
                            for (std::size_t i = 0; i < block; ++i) y[i] = computed(x[i]);
                          },
                          [](const Floats& x, Doubles& y, Doubles&) {
                            for (std::size_t i = 0; i < block; ++i)
                              y[i] = exact(static_cast<double>(x[i]));
                          }};

// In ulp of a float at the true value; those below 2^-126 all have the same unit.
Worst compare(const Floats& x, const Floats& computed, const Doubles& exact) {
  Doubles errors;
  for (std::size_t i = 0; i < block; ++i) {
    const std::uint64_t exponent = sinew_bits(exact[i]) & 0x7ff0000000000000U;
    const std::uint64_t normal = std::max(exponent, std::uint64_t{1023 - 126} << 52);
    const double per_unit = sinew_from_bits((std::uint64_t{2 * 1023 + 23} << 52) - normal);
    errors[i] = std::fabs(static_cast<double>(computed[i]) - exact[i]) * per_unit;
  }
  Worst worst;
  for (std::size_t i = 0; i < block; ++i) worst.take({errors[i], x[i]});
  return worst;
}

std::array<Worst, 2> sweep(const Function& function, std::uint64_t first, std::uint64_t last,
                           std::uint64_t stride) {
  std::array<Worst, 2> worst;
  Floats x, y, y2;
  Doubles exact, exact2;
  for (std::uint64_t low = first; low <= last; low += block * stride)
    for (const std::uint32_t sign : {0U, 0x80000000U}) {
      for (std::size_t i = 0; i < block; ++i)
        x[i] = std::bit_cast<float>(static_cast<std::uint32_t>(std::min(low + i * stride, last)) |
                                    sign);
      function.computed(x, y, y2);
      function.exact(x, exact, exact2);
      worst[0].take(compare(x, y, exact));
      if (function.results == 2) worst[1].take(compare(x, y2, exact2));
    }
  return worst;
}

// The range in 64 pieces, taken by as many threads as there are cores.
std::array<Worst, 2> run(const Function& function, float from, float to, std::uint64_t stride) {
  constexpr std::uint64_t pieces = 64;
  const std::uint64_t first = std::bit_cast<std::uint32_t>(from);
  const std::uint64_t last = std::bit_cast<std::uint32_t>(to);
  const std::uint64_t step = (last - first) / pieces + 1;
  std::vector<std::array<Worst, 2>> found(pieces);
  std::atomic<std::uint64_t> next{0};
  const auto work = [&] {
    for (std::uint64_t i = next++; i < pieces; i = next++)
      found[i] =
          sweep(function, first + i * step, std::min(first + (i + 1) * step - 1, last), stride);
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
      threads.emplace_back(work);
  }
  std::array<Worst, 2> worst;
  for (const auto& piece : found)
    for (std::size_t i = 0; i < 2; ++i) worst[i].take(piece[i]);
  return worst;
}

double positive_log(double x) {
  return sinew_log(sinew_abs(x));
}
float positive_logf(float x) {
  return sinew_logf(sinew_absf(x));
}

struct Case {
  const char* name;
  float from, to;  // magnitudes; both signs are taken
  double limit;    // ulp
  Function function;
};

constexpr float pi = std::numbers::pi_v<float>;
const std::vector<Case> cases = {
    {"sin, cos to pi", 0, pi, 1, pair<sinew_sincosf, sinew_sincos>},
    {"sin, cos, pi to 800", pi, 800, 1, pair<sinew_sincosf, sinew_sincos>},
    {"wide sin, cos to 4096", 0, 4096, 1, pair<sinew_sincos_widef, sinew_sincos_wide>},
    {"asin", 0, 1, 1, single<sinew_asinf, sinew_asin>},
    {"acos", 0, 1, 1, single<sinew_acosf, sinew_acos>},
    {"atan", 0, 0x1.fffffep126F, 1, single<sinew_atanf, sinew_atan>},
    {"exp to 87", 0, 87, 1, single<sinew_expf, sinew_exp>},
    {"log", 0x1p-126F, 0x1.fffffep127F, 1, single<positive_logf, positive_log>},
    {"tanh to 10", 0, 10, 3, single<sinew_tanhf, sinew_tanh>},
};

int check(const Case& one, std::uint32_t stride) {
  const std::array<Worst, 2> worst = run(one.function, one.from, one.to, stride);
  const std::uint64_t count = 2 * (1 + (std::uint64_t{std::bit_cast<std::uint32_t>(one.to)} -
                                        std::bit_cast<std::uint32_t>(one.from)) /
                                           stride);
  int status = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(one.function.results); ++i) {
    const bool good = worst[i].error <= one.limit;
    std::printf("%-22s %11llu floats, at most %.4f ulp at %a%s\n", one.name,
                static_cast<unsigned long long>(count), worst[i].error,
                static_cast<double>(worst[i].at), good ? "" : "  TOO LARGE");
    if (!good) status = 1;
  }
  std::fflush(stdout);
  return status;
}

}  // namespace

int main(int count, char** arguments) {
  std::uint32_t stride = 1;
  if (count > 1) {
    const std::string_view text = arguments[1];
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), stride);
    if (fault != std::errc{} || end != text.data() + text.size() || stride == 0) {
      std::fputs("usage: every_float [stride], a positive integer\n", stderr);
      return 2;
    }
  }
  int status = 0;
  for (const Case& one : cases) status = std::max(status, check(one, stride));
  return status;
}

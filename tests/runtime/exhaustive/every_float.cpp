// SPDX-License-Identifier: GPL-3.0-or-later
// Every float of its range through every float function of one argument, against the C library's
// double function (whose error, below 2^-28 ulp of a float, is far below what is printed).
//
// usage: every_float [stride]   stride 1 (the default) leaves none out
#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <string_view>
#include <thread>
#include <vector>

#include "../ulp.h"
#include "sinew_math.h"

namespace {

struct Worst {
  double error = 0;
  float at = 0;
  std::uint64_t count = 0;
};

struct Case {
  const char* name;
  float from, to;  // magnitudes; both signs are taken
  double limit;    // ulp, what docs/trigonometry.md states
  Worst (*run)(std::uint32_t first, std::uint32_t last, std::uint32_t stride);
};

std::uint32_t bits(float x) {
  std::uint32_t result;
  std::memcpy(&result, &x, sizeof result);
  return result;
}

float from_bits(std::uint32_t b) {
  float result;
  std::memcpy(&result, &b, sizeof result);
  return result;
}

template <float (*computed)(float), double (*exact)(double)>
Worst sweep(std::uint32_t first, std::uint32_t last, std::uint32_t stride) {
  Worst worst;
  for (std::uint64_t b = first; b <= last; b += stride)
    for (const float x :
         {from_bits(static_cast<std::uint32_t>(b)), -from_bits(static_cast<std::uint32_t>(b))}) {
      const double error = sinew::ulp_error(computed(x), exact(static_cast<double>(x)));
      if (!(error <= worst.error)) worst = {error, x, worst.count};
      ++worst.count;
    }
  return worst;
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
float wide_sine(float x) {
  float s, c;
  sinew_sincos_widef(x, &s, &c);
  return s;
}
float wide_cosine(float x) {
  float s, c;
  sinew_sincos_widef(x, &s, &c);
  return c;
}
float positive_log(float x) {
  return sinew_logf(sinew_absf(x));
}
double exact_log(double x) {
  return std::log(std::fabs(x));
}

constexpr float pi = std::numbers::pi_v<float>;
const std::vector<Case> cases = {
    {"sin, |x| <= pi", 0, pi, 1.0, sweep<sine, std::sin>},
    {"cos, |x| <= pi", 0, pi, 1.0, sweep<cosine, std::cos>},
    {"sin, pi..800", pi, 800, 1.0, sweep<sine, std::sin>},
    {"cos, pi..800", pi, 800, 1.0, sweep<cosine, std::cos>},
    {"sin wide, <= 4096", 0, 4096, 1.0, sweep<wide_sine, std::sin>},
    {"cos wide, <= 4096", 0, 4096, 1.0, sweep<wide_cosine, std::cos>},
    {"asin, |x| <= 1", 0, 1, 1.0, sweep<sinew_asinf, std::asin>},
    {"acos, |x| <= 1", 0, 1, 1.0, sweep<sinew_acosf, std::acos>},
    {"atan, every x", 0, 0x1.fffffep126F, 1.0, sweep<sinew_atanf, std::atan>},
    {"exp, |x| <= 87", 0, 87, 1.0, sweep<sinew_expf, std::exp>},
    {"log, normal x", 0x1p-126F, 0x1.fffffep127F, 1.0, sweep<positive_log, exact_log>},
    {"tanh, |x| <= 10", 0, 10, 3.0, sweep<sinew_tanhf, std::tanh>},
};

// The range in 64 pieces, taken by as many threads as there are cores.
Worst run(const Case& one, std::uint32_t stride) {
  constexpr std::uint32_t pieces = 64;
  const std::uint32_t first = bits(one.from), last = bits(one.to);
  const std::uint32_t step = (last - first) / pieces + 1;
  std::vector<Worst> found(pieces);
  std::atomic<std::uint32_t> next{0};
  const auto work = [&] {
    for (std::uint32_t i = next++; i < pieces; i = next++) {
      const std::uint64_t low = std::uint64_t{first} + std::uint64_t{i} * step;
      if (low > last) continue;
      found[i] = one.run(static_cast<std::uint32_t>(low),
                         static_cast<std::uint32_t>(std::min<std::uint64_t>(low + step - 1, last)),
                         stride);
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back(work);
  threads.clear();
  Worst worst;
  for (const Worst& piece : found) {
    if (!(piece.error <= worst.error)) worst = {piece.error, piece.at, worst.count};
    worst.count += piece.count;
  }
  return worst;
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
  for (const Case& one : cases) {
    const Worst worst = run(one, stride);
    const bool good = worst.error <= one.limit;
    std::printf("%-20s %11llu floats, at most %.4f ulp at %a%s\n", one.name,
                static_cast<unsigned long long>(worst.count), worst.error,
                static_cast<double>(worst.at), good ? "" : "  TOO LARGE");
    if (!good) status = 1;
  }
  return status;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The distance between the kernels' polynomials in real numbers and sin, cos: what gappa's proofs
// of the rounding take for granted. With a(r) the polynomial's own error and |tail| <= t,
//   |r + r z P + tail (1 - z/2) - sin(r + tail)| <= |a(r)| + t |cos r - 1 + z/2| + t^2.
// |a| is bounded by its values on a grid plus h^2/8 times a bound of its second derivative, so this
// is a bound and not a sample.
#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sinew_math.h"

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

// Coefficients of a(r)/r^first in powers of z: those of the kernel less those of Taylor's series,
// far enough for the rest of the series to be below 2^-90.
std::vector<Real> difference(const std::vector<double>& kernel, int first, int sign) {
  std::vector<Real> result;
  Real factorial = 1;
  for (int i = 2; i <= first; ++i) factorial *= i;
  for (int i = 0; i < 12; ++i) {
    const Real taylor = Real(sign) / factorial;
    const auto at = static_cast<std::size_t>(i);
    result.push_back((at < kernel.size() ? Real(kernel[at]) : Real(0)) - taylor);
    sign = -sign;
    factorial *= (first + 2 * i + 1) * (first + 2 * i + 2);
  }
  return result;
}

Real at(const std::vector<Real>& coefficients, const Real& z) {
  Real sum = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * z + *c;
  return sum;
}

// Bound of |sum c_i z^i| r^first over low <= r <= high.
Real bound(const std::vector<Real>& coefficients, int first, double low, double high) {
  const Real z0 = Real(low) * low, z1 = Real(high) * high;
  Real curvature = 0, power = 1;
  for (std::size_t i = 2; i < coefficients.size(); ++i, power *= z1)
    curvature += Real(static_cast<int>(i * (i - 1))) * abs(coefficients[i]) * power;
  const int steps = 1 << 13;
  const Real step = (z1 - z0) / steps;
  Real largest = 0, before = abs(at(coefficients, z0));
  for (int i = 1; i <= steps; ++i) {
    const Real z = z0 + step * i, here = abs(at(coefficients, z));
    const Real inside = std::max(before, here) + curvature * step * step / 8;
    largest = std::max<Real>(largest, inside * pow(sqrt(z), first));
    before = here;
  }
  return largest;
}

double sine_distance(const std::vector<double>& kernel, double low, double high, double tail) {
  const Real own = bound(difference(kernel, 3, -1), 3, low, high);
  return static_cast<double>(own + tail * (cos(Real(high)) - 1 + Real(high) * high / 2) +
                             Real(tail) * tail);
}

double cosine_distance(const std::vector<double>& kernel, double high, double tail) {
  const Real own = bound(difference(kernel, 4, 1), 4, 0, high);
  return static_cast<double>(own + tail * (Real(high) - sin(Real(high))) + Real(tail) * tail);
}

#include "sinew_double.h"
const std::vector<double> sine_double{SINEW_S1, SINEW_S2, SINEW_S3, SINEW_S4, SINEW_S5, SINEW_S6};
const std::vector<double> cosine_double{SINEW_C1, SINEW_C2, SINEW_C3, SINEW_C4, SINEW_C5, SINEW_C6};
#include "sinew_precision_end.h"

std::vector<double> widened(const std::vector<float>& values) {
  return {values.begin(), values.end()};
}

#include "sinew_float.h"
const std::vector<double> sine_float = widened({SINEW_S1, SINEW_S2, SINEW_S3});
const std::vector<double> cosine_float = widened({SINEW_C1, SINEW_C2, SINEW_C3});
#include "sinew_precision_end.h"

}  // namespace

// The figures are those of tests/runtime/gappa/proofs.cmake.
TEST_CASE("double polynomials are as close to sin and cos as the proofs assume") {
  CHECK(sine_distance(sine_double, 0.52359, 0.7854, 0x1p-54) <= 0x9p-61);
  CHECK(sine_distance(sine_double, 0.5, 0.52359, 0x1p-54) <= 0x1p-58);
  CHECK(sine_distance(sine_double, 0.25268, 0.5, 0x1p-55) <= 0x9p-62);
  CHECK(sine_distance(sine_double, 0.25, 0.25268, 0x1p-55) <= 0x1p-60);
  CHECK(sine_distance(sine_double, 0.12533, 0.25, 0x1p-56) <= 0x9p-63);
  CHECK(cosine_distance(cosine_double, 0.7854, 0x1p-54) <= 0x7p-60);
}

TEST_CASE("float polynomials are as close to sin and cos as the proofs assume") {
  CHECK(sine_distance(sine_float, 0.52359, 0.7854, 0x1p-25) <= 0xfp-32);
  CHECK(sine_distance(sine_float, 0.5, 0.52359, 0x1p-25) <= 0x1p-28);
  CHECK(sine_distance(sine_float, 0.25268, 0.5, 0x1p-26) <= 0x1p-29);
  CHECK(cosine_distance(cosine_float, 0.7854, 0x1p-25) <= 0x7p-31);
}

TEST_CASE("a coefficient that is two ulp off is too far away") {
  std::vector<double> wrong = sine_double;
  wrong[0] = std::nextafter(std::nextafter(wrong[0], 0.0), 0.0);
  CHECK(sine_distance(wrong, 0.52359, 0.7854, 0x1p-54) > 0x9p-61);
}

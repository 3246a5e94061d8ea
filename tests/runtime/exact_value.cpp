// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_value.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

class Number {
 public:
  explicit Number(double x) {
    mpfr_init2(value_, 200);
    mpfr_set_d(value_, x, MPFR_RNDN);
  }
  Number(const Number&) = delete;
  Number& operator=(const Number&) = delete;
  ~Number() { mpfr_clear(value_); }
  mpfr_ptr get() { return value_; }

 private:
  mpfr_t value_;
};

double distance(double computed, Number& exact) {
  if (!std::isfinite(computed)) return HUGE_VAL;
  // MPFR's exponent has the mantissa in [1/2, 1): the unit of a double is 2^(exponent - 53).
  const long exponent =
      mpfr_zero_p(exact.get()) ? -1021 : std::max(mpfr_get_exp(exact.get()), mpfr_exp_t{-1021});
  mpfr_sub_d(exact.get(), exact.get(), computed, MPFR_RNDN);
  mpfr_mul_2si(exact.get(), exact.get(), 53 - exponent, MPFR_RNDN);
  return std::fabs(mpfr_get_d(exact.get(), MPFR_RNDN));
}

}  // namespace

double ulp_error(double computed, ExactFunction function, double x) {
  Number exact(x);
  function(exact.get(), exact.get(), MPFR_RNDN);
  return distance(computed, exact);
}

double ulp_error(double computed, ExactFunctionOfTwo function, double y, double x) {
  Number exact(y), second(x);
  function(exact.get(), exact.get(), second.get(), MPFR_RNDN);
  return distance(computed, exact);
}

}  // namespace sinew

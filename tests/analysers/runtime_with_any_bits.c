/* SPDX-License-Identifier: GPL-3.0-or-later
 * Every function of sinew_math.h, its arguments any bits: NaN and infinities, too. */
#include "__fc_builtin.h"
#include "sinew_math.h"

static double any(void) {
  union {
    uint64_t bits;
    double real;
  } both;
  both.bits = Frama_C_unsigned_long_long_interval(0, UINT64_MAX);
  return both.real;
}

static float anyf(void) {
  union {
    uint32_t bits;
    float real;
  } both;
  both.bits = Frama_C_unsigned_int_interval(0, UINT32_MAX);
  return both.real;
}

static double in_double(void) {
  double s, c, sum;
  double x[4] = {any(), any(), any(), any()}, y[4], z[4];
  sinew_sincos(any(), &s, &c);
  sum = s + c;
  sinew_sincos_wide(any(), &s, &c);
  sinew_sincos4(x, y, z);
  sum += s + c + y[0] + y[3] + z[0] + z[3];
  sum += sinew_atan2(any(), any()) + sinew_atan(any()) + sinew_asin(any()) + sinew_acos(any());
  sum += sinew_exp(any()) + sinew_log(any()) + sinew_tanh(any()) + sinew_sqrt(any());
  return sum + sinew_choose(any(), any(), any()) + sinew_min(any(), any()) +
         sinew_max(any(), any()) + sinew_abs(any()) + sinew_finite(any());
}

static float in_float(void) {
  float s, c, sum;
  float x[4] = {anyf(), anyf(), anyf(), anyf()}, y[4], z[4];
  sinew_sincosf(anyf(), &s, &c);
  sum = s + c;
  sinew_sincos_widef(anyf(), &s, &c);
  sinew_sincos4f(x, y, z);
  sum += s + c + y[0] + y[3] + z[0] + z[3];
  sum += sinew_atan2f(anyf(), anyf()) + sinew_atanf(anyf()) + sinew_asinf(anyf()) +
         sinew_acosf(anyf());
  sum += sinew_expf(anyf()) + sinew_logf(anyf()) + sinew_tanhf(anyf()) + sinew_sqrtf(anyf());
  return sum + sinew_choosef(anyf(), anyf(), anyf()) + sinew_minf(anyf(), anyf()) +
         sinew_maxf(anyf(), anyf()) + sinew_absf(anyf()) + sinew_finitef(anyf());
}

int main(void) {
  return in_double() + (double)in_float() > 0.0;
}

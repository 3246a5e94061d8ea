/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * What the runtime's functions promise (docs/trigonometry.md), in place of how they do it: an
 * analyser of intervals cannot follow selections by masks of bits. That the functions keep these
 * promises is tested by tests/runtime, and that they have no run-time error for any input is the
 * other half of the analysis.
 */
#ifndef SINEW_MATH_H
#define SINEW_MATH_H

#include <math.h>
#include <stdint.h>

#include "__fc_builtin.h"

#define SINEW_INLINE static inline

/* Finite for every input, by 1.001 at most. */
SINEW_INLINE void sinew_sincos(double x, double* s, double* c) {
  (void)x;
  *s = Frama_C_double_interval(-1.001, 1.001);
  *c = Frama_C_double_interval(-1.001, 1.001);
}

SINEW_INLINE void sinew_sincos_wide(double x, double* s, double* c) {
  sinew_sincos(x, s, c);
}

SINEW_INLINE void sinew_sincos2(const double* x, double* s, double* c) {
  sinew_sincos(x[0], &s[0], &c[0]);
  sinew_sincos(x[1], &s[1], &c[1]);
}

SINEW_INLINE void sinew_sincos4(const double* x, double* s, double* c) {
  sinew_sincos2(x, s, c);
  sinew_sincos2(x + 2, s + 2, c + 2);
}

SINEW_INLINE double sinew_atan2(double y, double x) {
  (void)y;
  (void)x;
  return Frama_C_double_interval(-3.1416, 3.1416);
}

SINEW_INLINE double sinew_atan(double x) {
  (void)x;
  return Frama_C_double_interval(-1.5708, 1.5708);
}

SINEW_INLINE double sinew_asin(double x) {
  return sinew_atan(x);
}

SINEW_INLINE double sinew_acos(double x) {
  (void)x;
  return Frama_C_double_interval(0.0, 3.1416);
}

SINEW_INLINE double sinew_tanh(double x) {
  (void)x;
  return Frama_C_double_interval(-1.0, 1.0);
}

SINEW_INLINE double sinew_max(double a, double b) {
  return a > b ? a : b;
}
SINEW_INLINE double sinew_min(double a, double b) {
  return a < b ? a : b;
}
SINEW_INLINE double sinew_abs(double x) {
  return x < 0.0 ? -x : x;
}
SINEW_INLINE double sinew_choose(double t, double a, double b) {
  return t >= 0.0 ? a : b;
}
SINEW_INLINE double sinew_finite(double x) {
  return x;
}

/* Monotonous, so that an analyser of intervals may take the C library's. */
SINEW_INLINE double sinew_exp(double x) {
  return exp(sinew_max(-708.0, sinew_min(x, 708.0)));
}
SINEW_INLINE double sinew_log(double x) {
  return log(sinew_max(x, 2.2250738585072014e-308));
}
SINEW_INLINE double sinew_sqrt(double x) {
  return sqrt(sinew_max(x, 0.0));
}

#endif

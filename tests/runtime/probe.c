/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Every function of the runtime as one symbol, and a few uses as emitted code has them, to look at the
 * object code. With PLANTED_BRANCH and PLANTED_CALL, defects that must be found.
 */
#include "sinew_math.h"

#define ONE_ARGUMENT(name)                      \
    double probe_##name(double x);              \
    double probe_##name(double x) {             \
        return sinew_##name(x);                 \
    }                                           \
    float probe_##name##f(float x);             \
    float probe_##name##f(float x) {            \
        return sinew_##name##f(x);              \
    }
#define TWO_ARGUMENTS(name)                     \
    double probe_##name(double x, double y);    \
    double probe_##name(double x, double y) {   \
        return sinew_##name(x, y);              \
    }                                           \
    float probe_##name##f(float x, float y);    \
    float probe_##name##f(float x, float y) {   \
        return sinew_##name##f(x, y);           \
    }
#define SINE_AND_COSINE(name)                                        \
    void probe_##name(double x, double *s, double *c);               \
    void probe_##name(double x, double *s, double *c) {              \
        sinew_##name(x, s, c);                                       \
    }                                                                \
    void probe_##name##f(float x, float *s, float *c);               \
    void probe_##name##f(float x, float *s, float *c) {              \
        sinew_##name##f(x, s, c);                                    \
    }
#define SINES_AND_COSINES(name)                                      \
    void probe_##name(const double *x, double *s, double *c);        \
    void probe_##name(const double *x, double *s, double *c) {       \
        sinew_##name(x, s, c);                                       \
    }                                                                \
    void probe_##name##f(const float *x, float *s, float *c);        \
    void probe_##name##f(const float *x, float *s, float *c) {       \
        sinew_##name##f(x, s, c);                                    \
    }

SINE_AND_COSINE(sincos)
SINE_AND_COSINE(sincos_wide)
SINES_AND_COSINES(sincos2)
SINES_AND_COSINES(sincos4)
ONE_ARGUMENT(atan)
ONE_ARGUMENT(acos)
ONE_ARGUMENT(asin)
ONE_ARGUMENT(exp)
ONE_ARGUMENT(log)
ONE_ARGUMENT(tanh)
ONE_ARGUMENT(sqrt)
ONE_ARGUMENT(abs)
ONE_ARGUMENT(finite)
TWO_ARGUMENTS(atan2)
TWO_ARGUMENTS(min)
TWO_ARGUMENTS(max)

double probe_choose(double x, double y, double z);
double probe_choose(double x, double y, double z) {
    return sinew_choose(x, sinew_sqrt(y), sinew_min(y, z)) * sinew_choose(x, z, sinew_max(x, z));
}

float probe_choosef(float x, float y, float z);
float probe_choosef(float x, float y, float z) {
    return sinew_choosef(x, sinew_sqrtf(y), sinew_minf(y, z)) *
           sinew_choosef(x, z, sinew_maxf(x, z));
}

#ifdef PLANTED_BRANCH
double planted_branch(double x, const double *y, volatile double *z);
double planted_branch(double x, const double *y, volatile double *z) {
    if (x > 0.0) {
        *z = *y;
    }
    return x;
}
#endif

#ifdef PLANTED_CALL
double sin(double x);
double planted_call(double x);
double planted_call(double x) {
    return sin(x) + 1.0;
}
#endif

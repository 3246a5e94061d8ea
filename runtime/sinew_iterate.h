/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Searching a zero with a fixed number of evaluations: the time is the same for every input.
 */
#ifndef SINEW_ITERATE_H
#define SINEW_ITERATE_H

#ifdef __cplusplus
extern "C" {
#endif

/* f(x) and its derivative at x; `context` is handed through. */
typedef void (*sinew_slope_function)(const void *context, double x, double *value, double *slope);

typedef struct {
    double x;        /* within low..high and finite, whatever the function gives */
    double residual; /* f there */
} sinew_zero;

/* `count` steps of Newton's method from `start`, each held within low..high (low <= high, finite);
 * from a flat place to the limit on the side that the residual's sign says, and nowhere where a
 * step is no number. f is evaluated count + 1 times. Whether the zero was reached is told by the
 * residual. A start that is no number counts as `low`. */
static inline sinew_zero sinew_newton(sinew_slope_function f, const void *context, double start,
                                      double low, double high, int count) {
    sinew_zero at = {low, 0.0};
    double slope = 0.0;
    if (start >= low) at.x = start > high ? high : start;
    f(context, at.x, &at.residual, &slope);
    for (int i = 0; i < count; ++i) {
        const double next = at.x - at.residual / slope;
        if (next < low)
            at.x = low;
        else if (next > high)
            at.x = high;
        else if (next == next)
            at.x = next;
        f(context, at.x, &at.residual, &slope);
    }
    return at;
}

#ifdef __cplusplus
}
#endif
#endif

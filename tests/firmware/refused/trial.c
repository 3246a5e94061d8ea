/* SPDX-License-Identifier: BSD-2-Clause */
/* A model of one function, right as it stands; a macro plants one defect that the comparison of host
 * and board must refuse before it compares anything. */
#include "sinew_catalogue.h"

extern const sinew_catalogue trial_catalogue;

#ifdef TRIAL_TOO_LARGE
#define SIZE 5000
#else
#define SIZE 2
#endif
#ifdef TRIAL_SIZES_DIFFER
#define STATED_SIZE 3
#else
#define STATED_SIZE SIZE
#endif
#ifdef TRIAL_SCALAR_UNKNOWN
#define SCALAR_BYTES 2
#else
#define SCALAR_BYTES 8
#endif

static void call_product(const void *in, void *out) {
  const double *x = in;
  double *y = out;
  y[0] = x[0] * x[1];
#ifdef TRIAL_NOT_FINITE
  y[1] = x[0] / (x[1] - 2.0); /* 2 is the upper end of the range */
#else
  y[1] = x[0] / (x[1] + 3.0);
#endif
#ifdef TRIAL_OVERRUN
  y[2] = 0.0;
#endif
}

static const double low[2] = {1.0, -2.0};
static const double high[2] = {4.0, 2.0};
static const sinew_argument input = {"x", "m", 2, 1, low, high};
static const sinew_argument output = {"y", "m", SIZE, 1, 0, 0};
static const sinew_function functions[1] = {
    {"trial_product", 1, 1, 2, STATED_SIZE, &input, &output, call_product}};
const sinew_catalogue trial_catalogue = {"trial", "none", SCALAR_BYTES, 1, functions};

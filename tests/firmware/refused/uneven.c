/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: a model whose number of instructions depends on its input. */
#include "sinew_catalogue.h"

extern const sinew_catalogue uneven_catalogue;

__attribute__((noinline)) void uneven_sum(const double *x, double *y);
void uneven_sum(const double *x, double *y) {
  double sum = 0.0;
  for (double term = x[0]; term > 1.0; term *= 0.5) sum += term / (1.0 + x[0]);
  y[0] = sum;
}

static void call_sum(const void *in, void *out) { uneven_sum(in, out); }

static const double low[1] = {1.0};
static const double high[1] = {100.0};
static const sinew_argument input = {"x", "m", 1, 1, low, high};
static const sinew_argument output = {"y", "m", 1, 1, 0, 0};
static const sinew_function functions[1] = {{"uneven_sum", 1, 1, 1, 1, &input, &output, call_sum}};
const sinew_catalogue uneven_catalogue = {"uneven", "none", 8, 1, functions};

/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: memory from the heap. */
#include <stdlib.h>
void planted_heap(double **out);
void planted_heap(double **out) { *out = malloc(8 * sizeof **out); }

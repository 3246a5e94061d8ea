/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planted defect: memory from the heap. */
#include <stdlib.h>
void planted_heap(double **out);
void planted_heap(double **out) { *out = malloc(8 * sizeof **out); }

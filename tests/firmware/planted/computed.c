/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: a call through a pointer that becomes a computed jump. */
void planted_computed(void (*next)(double *), double *out);
void planted_computed(void (*next)(double *), double *out) { next(out); }

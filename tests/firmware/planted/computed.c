/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Planted defect: a call through a pointer that becomes a computed jump. */
void planted_computed(void (*next)(double *), double *out);
void planted_computed(void (*next)(double *), double *out) { next(out); }

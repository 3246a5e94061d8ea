/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: two frames that are too large only together. The empty assembly statements keep
 * the compiler from leaving the arrays out. */
__attribute__((noinline)) static void inner(const double *in, double *out) {
  double values[192];
  __asm__ volatile("" ::"r"(values) : "memory");
  out[0] = values[0] + in[0];
}
void planted_deep(const double *in, double *out);
void planted_deep(const double *in, double *out) {
  double values[192];
  double inside = 0.0;
  __asm__ volatile("" ::"r"(values) : "memory");
  inner(in, &inside);
  out[1] = values[1] + inside;
}

/* SPDX-License-Identifier: BSD-2-Clause */
/* Planted defect: a frame whose size depends on an input. */
void planted_varying(int size, double *out);
void planted_varying(int size, double *out) {
  volatile double values[size];
  values[0] = 1.0;
  out[0] = values[0];
}

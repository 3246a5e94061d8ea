/* SPDX-License-Identifier: GPL-3.0-or-later
 * What Eva has to find: an index beyond the end, a shift by too much, a value that was never set, a
 * number too large for an integer. */
#include "__fc_builtin.h"
#include "sinew_math.h"

int main(void) {
  double table[4] = {0.0, 1.0, 2.0, 3.0};
  double unset;
  const int at = Frama_C_interval(0, 4);
  const uint64_t shifted = (uint64_t)1 << Frama_C_interval(0, 64);
  if (at == 0) return (int)unset;
  return (int)(table[at] + (double)shifted);
}

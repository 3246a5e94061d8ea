/* SPDX-License-Identifier: GPL-3.0-or-later
 *
 * A user of the installed index finger in C: calls one function by its name and all of them through
 * the catalogue. Status 0 if every result is finite.
 */
#include <stdio.h>

#include "index.h"
#include "index_batch.h"
#include "index_catalogue.h"

#define ELEMENTS 4096

static double input[ELEMENTS];
static double output[ELEMENTS];

static int is_finite(double value) { return value - value == 0.0; }

static int middle_is_finite(const sinew_function *function) {
  int position = 0;
  for (int i = 0; i < function->input_count; ++i) {
    const sinew_argument *argument = &function->inputs[i];
    for (int k = 0; k < argument->rows * argument->cols; ++k) {
      input[position++] =
          argument->low != NULL ? 0.5 * (argument->low[k] + argument->high[k]) : 0.5;
    }
  }
  function->call(input, output);
  for (int i = 0; i < function->output_size; ++i) {
    if (!is_finite(output[i])) return 0;
  }
  return 1;
}

/* The loops over many states give what one call gives: element k of state i is at [k * count + i]. */
static int batch_is_the_same(void) {
  const double q[4] = {0.0, 0.1, 0.2, 0.3}, states[8] = {0.0, 0.0, 0.1, 0.1, 0.2, 0.2, 0.3, 0.3};
  double one[16], two[32];
  index_mass_matrix(q, one);
  index_mass_matrix_batch(2, states, two);
  for (int k = 0; k < 16; ++k) {
    if (two[2 * k] != one[k] || two[2 * k + 1] != one[k]) return 0;
  }
  return 1;
}

int main(void) {
  const double q[4] = {0.0, 0.1, 0.2, 0.3};
  double pose[16];
  index_forward_kinematics(q, pose);
  int bad = pose[15] != 1.0 || !batch_is_the_same();
  for (int i = 0; i < index_catalogue.function_count; ++i) {
    const sinew_function *function = &index_catalogue.functions[i];
    if (function->input_size > ELEMENTS || function->output_size > ELEMENTS ||
        !middle_is_finite(function)) {
      printf("%s: not finite\n", function->name);
      bad = 1;
    }
  }
  printf("%d functions called\n", index_catalogue.function_count);
  return bad != 0 || index_catalogue.function_count == 0;
}

/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Evaluates every function of a model at the host's states and compares the bits of all results
 * with the host's. Status: PORT_STATUS_EQUAL or PORT_STATUS_DIFFERENT.
 */
#include "equality.h"

#include <string.h>

#include "console.h"
#include "evaluation.h"
#include "port.h"

extern const sinew_catalogue EQUALITY_CATALOGUE;

static void print_bits(const char *label, uint64_t bits) {
  console_text(label);
  console_hexadecimal(bits);
}

/* One line for an element that differs; 0 if it is equal. */
static int report_element(const equality_function *expected, uint32_t state, int element) {
  const uint64_t host = expected->kept[(int)state * expected->output_size + element];
  const uint64_t board = evaluation_output_bits(element);
  if (host == board) return 0;
  console_text("  ");
  console_text(expected->name);
  console_text(": state ");
  console_decimal(state);
  console_text(", element ");
  console_decimal((uint32_t)element);
  print_bits(": host ", host);
  print_bits(", board ", board);
  console_text("\n");
  return 1;
}

static void report_block(const equality_function *expected, uint32_t first, uint32_t last) {
  console_text("  ");
  console_text(expected->name);
  console_text(": first difference in states ");
  console_decimal(first);
  console_text(" to ");
  console_decimal(last);
  console_text("; the host's bits: expected_");
  console_text(equality_expected.model);
  console_text(" show ");
  console_text(expected->name);
  console_text(" ");
  console_decimal(last);
  console_text("; the board's bits at the last of them:\n ");
  for (int i = 0; i < expected->output_size; ++i) print_bits(" ", evaluation_output_bits(i));
  console_text("\n");
}

static void report_status(const char *name, evaluation_status status, uint32_t state) {
  console_text("  ");
  console_text(name);
  console_text(": state ");
  console_decimal(state);
  console_text(": ");
  console_text(evaluation_message(status));
  console_text("\n");
}

/* Kept states are compared element by element; each difference has its line. */
static int compare_kept(const equality_function *expected, uint32_t state) {
  if (state >= EQUALITY_KEPT_STATES) return 0;
  int differences = 0;
  for (int i = 0; i < expected->output_size; ++i) differences += report_element(expected, state, i);
  return differences;
}

static int at_checkpoint(uint32_t state) {
  return (state + 1U) % equality_expected.stride == 0U || state + 1U == equality_expected.states;
}

/* 1 if a result differs. Only the first checkpoint that differs is told: all later ones do too. */
static int compare_function(const sinew_function *function, const equality_function *expected) {
  uint64_t hash = EVALUATION_HASH_START;
  int told = 0;
  int differences = 0;
  for (uint32_t state = 0; state < equality_expected.states; ++state) {
    const evaluation_status status =
        evaluation_run(function, equality_expected.scalar_bytes, state);
    if (status != EVALUATION_FINE) {
      report_status(function->name, status, state);
      return 1;
    }
    hash = evaluation_fold(hash);
    differences += compare_kept(expected, state);
    if (at_checkpoint(state) && told == 0) {
      const uint32_t block = state / equality_expected.stride;
      told = expected->checkpoints[block] != (uint32_t)(hash >> 32);
      if (told != 0) report_block(expected, block * equality_expected.stride, state);
    }
  }
  console_text(hash == expected->hash && differences == 0 ? "equal     " : "DIFFERENT ");
  print_bits("", hash);
  console_text(" ");
  console_text(function->name);
  console_text("\n");
  return hash != expected->hash || differences != 0;
}

static int same_function(const sinew_function *function, const equality_function *expected) {
  return strcmp(function->name, expected->name) == 0 &&
         function->output_size == expected->output_size;
}

/* 1 if the image's model is the one the host's table was made from. */
static int same_model(const sinew_catalogue *model) {
  if (strcmp(model->model, equality_expected.model) != 0 ||
      strcmp(model->hash, equality_expected.model_hash) != 0 ||
      model->scalar_bytes != equality_expected.scalar_bytes ||
      model->function_count != equality_expected.function_count) {
    return 0;
  }
  for (int i = 0; i < model->function_count; ++i) {
    if (!same_function(&model->functions[i], &equality_expected.functions[i])) return 0;
  }
  return model->function_count > 0;
}

static int finish(const sinew_catalogue *model, int different) {
  console_text(different == 0 ? "PASS: " : "FAIL: ");
  console_text(model->model);
  console_text(": ");
  console_decimal((uint32_t)(model->function_count - different));
  console_text(" of ");
  console_decimal((uint32_t)model->function_count);
  console_text(" functions have the host's bits at ");
  console_decimal(equality_expected.states);
  console_text(" states each\n");
  return different == 0 ? PORT_STATUS_EQUAL : PORT_STATUS_DIFFERENT;
}

int main(void) {
  const sinew_catalogue *model = &EQUALITY_CATALOGUE;
  if (!same_model(model)) {
    console_text("FAIL: the image's model is not the one the host's results were computed with\n");
    return PORT_STATUS_DIFFERENT;
  }
  int different = 0;
  for (int i = 0; i < model->function_count; ++i) {
    different += compare_function(&model->functions[i], &equality_expected.functions[i]);
  }
  return finish(model, different);
}

/* SPDX-License-Identifier: BSD-2-Clause */
#include "evaluation.h"

#include <string.h>

#include "states.h"

/* Eight bytes an element; a model in float uses the first half. Behind the results stays one
 * element that no function may write. */
static uint64_t input[EVALUATION_INPUT_LIMIT];
static uint64_t output[EVALUATION_OUTPUT_LIMIT + 1];
static int element_bytes = 8;
static int output_size;

static const unsigned char guard = 0xa5;

const char *evaluation_message(evaluation_status status) {
  switch (status) {
    case EVALUATION_FINE:
      return "fine";
    case EVALUATION_SCALAR_UNKNOWN:
      return "its elements are neither 4 nor 8 bytes";
    case EVALUATION_SIZES_DIFFER:
      return "its arguments do not add up to its stated size";
    case EVALUATION_TOO_LARGE:
      return "it does not fit EVALUATION_INPUT_LIMIT and EVALUATION_OUTPUT_LIMIT";
    case EVALUATION_OVERRUN:
      return "it wrote behind its last result";
    default:
      return "a result inside the stated ranges is not finite";
  }
}

static int elements(const sinew_argument *arguments, int count) {
  int sum = 0;
  for (int i = 0; i < count; ++i) sum += arguments[i].rows * arguments[i].cols;
  return sum;
}

static evaluation_status fits(const sinew_function *function, int scalar_bytes) {
  if (scalar_bytes != 4 && scalar_bytes != 8) return EVALUATION_SCALAR_UNKNOWN;
  if (elements(function->inputs, function->input_count) != function->input_size ||
      elements(function->outputs, function->output_count) != function->output_size) {
    return EVALUATION_SIZES_DIFFER;
  }
  if (function->input_size > EVALUATION_INPUT_LIMIT ||
      function->output_size > EVALUATION_OUTPUT_LIMIT) {
    return EVALUATION_TOO_LARGE;
  }
  return EVALUATION_FINE;
}

static uint64_t bits_at(const uint64_t *buffer, int element) {
  const char *place = (const char *)buffer + (element * element_bytes);
  if (element_bytes == 4) {
    uint32_t half;
    memcpy(&half, place, sizeof half);
    return half;
  }
  uint64_t whole;
  memcpy(&whole, place, sizeof whole);
  return whole;
}

uint64_t evaluation_input_bits(int element) { return bits_at(input, element); }
uint64_t evaluation_output_bits(int element) { return bits_at(output, element); }

static int is_finite(uint64_t bits) {
  const uint64_t exponent =
      element_bytes == 4 ? UINT64_C(0x7f800000) : UINT64_C(0x7ff0000000000000);
  return (bits & exponent) != exponent;
}

static evaluation_status verdict(void) {
  const unsigned char *behind = (const unsigned char *)output + (output_size * element_bytes);
  for (int i = 0; i < element_bytes; ++i) {
    if (behind[i] != guard) return EVALUATION_OVERRUN;
  }
  for (int i = 0; i < output_size; ++i) {
    if (!is_finite(evaluation_output_bits(i))) return EVALUATION_NOT_FINITE;
  }
  return EVALUATION_FINE;
}

evaluation_status evaluation_run(const sinew_function *function, int scalar_bytes, uint32_t state) {
  const evaluation_status status = fits(function, scalar_bytes);
  if (status != EVALUATION_FINE) return status;
  element_bytes = scalar_bytes;
  output_size = function->output_size;
  memset(output, guard, (size_t)(output_size + 1) * (size_t)element_bytes);
  state_draw(function, scalar_bytes, state, input);
  function->call(input, output);
  return verdict();
}

uint64_t evaluation_fold(uint64_t hash) {
  for (int i = 0; i < output_size; ++i) {
    hash = (hash ^ evaluation_output_bits(i)) * UINT64_C(0x9fb21c651e98df25);
    hash ^= hash >> 32;
  }
  return hash;
}

/* SPDX-License-Identifier: BSD-2-Clause
 *
 * One call of one emitted function at one state, with what can go wrong, and the folding of
 * results into hashes. Compiled for the host and for the board.
 */
#ifndef SINEW_EVALUATION_H
#define SINEW_EVALUATION_H

#include <stdint.h>

#include "sinew_catalogue.h"

/* Largest function that fits the static buffers, in elements of all inputs or results together. */
#define EVALUATION_INPUT_LIMIT 1024
#define EVALUATION_OUTPUT_LIMIT 4096

typedef enum {
  EVALUATION_FINE,
  EVALUATION_SCALAR_UNKNOWN, /* elements are neither 4 nor 8 bytes */
  EVALUATION_SIZES_DIFFER,   /* the arguments' rows and columns do not add up to the stated size */
  EVALUATION_TOO_LARGE,      /* the function does not fit the buffers */
  EVALUATION_OVERRUN,        /* the function wrote behind its last result */
  EVALUATION_NOT_FINITE      /* a result is infinite or not a number */
} evaluation_status;

/* What a status means, for a message. */
const char *evaluation_message(evaluation_status status);

/* Calls the function at state number `state` (see states.h). */
evaluation_status evaluation_run(const sinew_function *function, int scalar_bytes, uint32_t state);

/* Bits of element `element` of the inputs and of the results of the last call. */
uint64_t evaluation_input_bits(int element);
uint64_t evaluation_output_bits(int element);

/* Folds all results of the last call into a hash. Every step is a bijection of the hash, so two
 * sequences that differ in one element have different hashes. */
uint64_t evaluation_fold(uint64_t hash);
#define EVALUATION_HASH_START UINT64_C(0x243f6a8885a308d3)

#endif

/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The host's results in the form the board compares with. expected_table.c writes them as C.
 */
#ifndef SINEW_EQUALITY_H
#define SINEW_EQUALITY_H

#include <stdint.h>

/* Of the first states all results are kept, so that a difference can be shown bit by bit. */
#define EQUALITY_KEPT_STATES 8

typedef struct {
  const char *name;
  int output_size;
  uint64_t hash;               /* of all results at all states */
  const uint32_t *checkpoints; /* upper half of the hash after every `stride` states */
  const uint64_t *kept;        /* EQUALITY_KEPT_STATES rows of output_size elements */
} equality_function;

typedef struct {
  const char *model;
  const char *model_hash;
  int scalar_bytes;
  uint32_t states;
  uint32_t stride;
  int function_count;
  const equality_function *functions;
} equality_table;

extern const equality_table equality_expected;

/* The catalogue of the model the program was built for: SINEW_MODEL is its name. */
#define EQUALITY_JOIN(model, suffix) model##suffix
#define EQUALITY_CATALOGUE_OF(model) EQUALITY_JOIN(model, _catalogue)
#define EQUALITY_CATALOGUE EQUALITY_CATALOGUE_OF(SINEW_MODEL)

#endif

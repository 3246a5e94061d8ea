/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Host program: computes a model's results at the states the board will compute and writes them as
 * the C source of equality_expected.
 *
 *   expected_<model> write <file> <states> [planted]
 *       With `planted`, one bit of the first function's hash, checkpoints and first kept result is
 *       turned: an image built from it must find the difference.
 *   expected_<model> show <function> <state>
 *       Bits of inputs and results at one state, to compare with what a board printed.
 *
 * Status: 0 done, 1 the model's results cannot be compared, 2 wrong usage or the file not written.
 */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "equality.h"
#include "evaluation.h"

#define CHECKPOINT_LIMIT 1024U

extern const sinew_catalogue EQUALITY_CATALOGUE;
static const sinew_catalogue *const model = &EQUALITY_CATALOGUE;

typedef struct {
  uint32_t states;
  uint32_t stride;
  int planted; /* whether the first function gets a difference */
} request;

static int refuse(const sinew_function *function, uint32_t state, evaluation_status status) {
  fprintf(stderr, "%s: function %s, state %" PRIu32 ": %s\n", model->model, function->name, state,
          evaluation_message(status));
  return 1;
}

static uint32_t turned_bit(const request *asked, int index) {
  return asked->planted && index == 0 ? 1U : 0U;
}

static int write_kept(FILE *file, const sinew_function *function, int index, uint64_t flip) {
  fprintf(file, "static const uint64_t kept_%d[] = {", index);
  for (uint32_t state = 0; state < EQUALITY_KEPT_STATES; ++state) {
    const evaluation_status status = evaluation_run(function, model->scalar_bytes, state);
    if (status != EVALUATION_FINE) return refuse(function, state, status);
    for (int i = 0; i < function->output_size; ++i) {
      fprintf(file, "\n  UINT64_C(0x%016" PRIx64 "),", evaluation_output_bits(i) ^ flip);
      flip = 0;
    }
  }
  fprintf(file, "\n};\n");
  return 0;
}

static int write_checkpoints(FILE *file, const request *asked, int index, uint64_t *hash) {
  const sinew_function *function = &model->functions[index];
  const uint32_t flip = turned_bit(asked, index);
  *hash = EVALUATION_HASH_START;
  fprintf(file, "static const uint32_t checkpoints_%d[] = {", index);
  for (uint32_t state = 0; state < asked->states; ++state) {
    const evaluation_status status = evaluation_run(function, model->scalar_bytes, state);
    if (status != EVALUATION_FINE) return refuse(function, state, status);
    *hash = evaluation_fold(*hash);
    if ((state + 1U) % asked->stride == 0U || state + 1U == asked->states) {
      fprintf(file, "\n  0x%08" PRIx32 "U,", (uint32_t)(*hash >> 32) ^ flip);
    }
  }
  *hash ^= flip;
  fprintf(file, "\n};\n");
  return 0;
}

static int write_arrays(FILE *file, const request *asked, uint64_t *hashes) {
  for (int i = 0; i < model->function_count; ++i) {
    if (write_checkpoints(file, asked, i, &hashes[i]) != 0) return 1;
    if (write_kept(file, &model->functions[i], i, turned_bit(asked, i)) != 0) return 1;
  }
  return 0;
}

static void write_table(FILE *file, const request *asked, const uint64_t *hashes) {
  fprintf(file, "static const equality_function functions[] = {\n");
  for (int i = 0; i < model->function_count; ++i) {
    const sinew_function *function = &model->functions[i];
    fprintf(file, "  {\"%s\", %d, UINT64_C(0x%016" PRIx64 "), checkpoints_%d, kept_%d},\n",
            function->name, function->output_size, hashes[i], i, i);
  }
  fprintf(file, "};\n");
  fprintf(file, "const equality_table equality_expected = {\n");
  fprintf(file, "  \"%s\", \"%s\", %d, %" PRIu32 "U, %" PRIu32 "U, %d, functions};\n",
          model->model, model->hash, model->scalar_bytes, asked->states, asked->stride,
          model->function_count);
}

static int write_source(FILE *file, const request *asked) {
  uint64_t *hashes = calloc((size_t)model->function_count + 1U, sizeof *hashes);
  if (hashes == NULL) return 2;
  fprintf(file, "/* SPDX-License-Identifier: BSD-2-Clause */\n");
  fprintf(file, "/* Written by expected_%s: the host's results. */\n", model->model);
  fprintf(file, "#include \"equality.h\"\n");
  const int status = write_arrays(file, asked, hashes);
  if (status == 0) write_table(file, asked, hashes);
  free(hashes);
  return status;
}

/* Writes beside the file and renames at the end: a build never goes on with half a table. */
static int write_file(const char *path, const request *asked) {
  char beside[4096];
  const int length = snprintf(beside, sizeof beside, "%s.part", path);
  FILE *file = length > 0 && length < (int)sizeof beside ? fopen(beside, "w") : NULL;
  if (file == NULL) {
    fprintf(stderr, "%s.part: cannot be made: %s\n", path, strerror(errno));
    return 2;
  }
  int status = write_source(file, asked);
  if (ferror(file) != 0 && status == 0) status = 2;
  if (fclose(file) != 0 && status == 0) status = 2;
  if (status == 0 && rename(beside, path) != 0) status = 2;
  if (status == 2) fprintf(stderr, "%s: not written: %s\n", path, strerror(errno));
  if (status != 0) remove(beside);
  return status;
}

static const sinew_function *function_named(const char *name) {
  for (int i = 0; i < model->function_count; ++i) {
    if (strcmp(model->functions[i].name, name) == 0) return &model->functions[i];
  }
  fprintf(stderr, "%s has no function '%s'\n", model->model, name);
  return NULL;
}

static int show(const char *name, uint32_t state) {
  const sinew_function *function = function_named(name);
  if (function == NULL) return 2;
  const evaluation_status status = evaluation_run(function, model->scalar_bytes, state);
  if (status != EVALUATION_FINE && status != EVALUATION_NOT_FINITE) {
    return refuse(function, state, status);
  }
  for (int i = 0; i < function->input_size; ++i) {
    printf("in  %d %016" PRIx64 "\n", i, evaluation_input_bits(i));
  }
  for (int i = 0; i < function->output_size; ++i) {
    printf("out %d %016" PRIx64 "\n", i, evaluation_output_bits(i));
  }
  return status == EVALUATION_FINE ? 0 : refuse(function, state, status);
}

/* A whole number of at least `least`; 0 and a message otherwise. */
static int read_number(const char *text, unsigned long least, uint32_t *number) {
  char *end = NULL;
  errno = 0;
  const unsigned long value = strtoul(text, &end, 10);
  if (errno != 0 || end == text || *end != '\0' || value < least || value > 0xffffffffUL) {
    fprintf(stderr, "'%s' is not a whole number of at least %lu\n", text, least);
    return 0;
  }
  *number = (uint32_t)value;
  return 1;
}

int main(int count, char **words) {
  uint32_t number = 0;
  if (count == 4 && strcmp(words[1], "show") == 0) {
    return read_number(words[3], 0, &number) ? show(words[2], number) : 2;
  }
  const int planted = count == 5 && strcmp(words[4], "planted") == 0;
  if ((count == 4 || planted) && strcmp(words[1], "write") == 0) {
    if (!read_number(words[3], EQUALITY_KEPT_STATES, &number)) return 2;
    const request asked = {number, (number + CHECKPOINT_LIMIT - 1U) / CHECKPOINT_LIMIT, planted};
    return write_file(words[2], &asked);
  }
  fprintf(stderr, "usage: %s write <file> <states> [planted] | show <function> <state>\n",
          count > 0 ? words[0] : "expected");
  return 2;
}

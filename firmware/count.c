/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Calls every function of a model at many states between two marks, for count_plugin.c. Prints the
 * functions' names in the order of the plugin's groups; group 0 is an empty function, whose count
 * is what the marks and the call cost. The plugin leaves out what is named call_...: the catalogue's
 * wrappers and the empty function.
 */
#include "console.h"
#include "equality.h"
#include "evaluation.h"
#include "port.h"
#include "states.h"

#ifndef COUNT_STATES
#define COUNT_STATES 10000U
#endif

extern const sinew_catalogue EQUALITY_CATALOGUE;

static uint64_t input[EVALUATION_INPUT_LIMIT];
static uint64_t output[EVALUATION_OUTPUT_LIMIT];

/* The plugin finds these by name; each must be one instruction, its return. */
__attribute__((noinline)) void count_group(void) { __asm__ volatile("" ::: "memory"); }
__attribute__((noinline)) void count_begin(void) { __asm__ volatile("" ::: "memory"); }
__attribute__((noinline)) void count_end(void) { __asm__ volatile("" ::: "memory"); }

static void call_empty(const void *in, void *out) {
  (void)in;
  (void)out;
}

static void count_function(const sinew_function *function, int scalar_bytes) {
  console_text("group ");
  console_text(function->name);
  console_text("\n");
  state_draw(function, scalar_bytes, 0U, input); /* what starts something does so before */
  function->call(input, output);
  count_group();
  for (uint32_t state = 0; state < COUNT_STATES; ++state) {
    state_draw(function, scalar_bytes, state, input);
    count_begin();
    function->call(input, output);
    count_end();
  }
}

int main(void) {
  const sinew_catalogue *model = &EQUALITY_CATALOGUE;
  const sinew_function empty = {"(empty)", 0, 0, 0, 0, 0, 0, call_empty};
  count_function(&empty, model->scalar_bytes);
  for (int i = 0; i < model->function_count; ++i) {
    if (model->functions[i].input_size > EVALUATION_INPUT_LIMIT ||
        model->functions[i].output_size > EVALUATION_OUTPUT_LIMIT) {
      console_text("FAIL: a function does not fit the buffers\n");
      return PORT_STATUS_DIFFERENT;
    }
    count_function(&model->functions[i], model->scalar_bytes);
  }
  return 0;
}

/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The skeleton of a 3 kHz control loop: wait for the period, read the sensors, evaluate the model,
 * command the actuators. Here the sensors are drawn states and every function of the model is
 * evaluated in every period, with the time of each taken. Status: 1 if a period was overrun.
 */
#include "console.h"
#include "equality.h"
#include "evaluation.h"
#include "port.h"
#include "states.h"

#define LOOP_RATE 3000U
#define LOOP_PERIODS 150U
#define FUNCTION_LIMIT 256

extern const sinew_catalogue EQUALITY_CATALOGUE;
static const sinew_catalogue *const model = &EQUALITY_CATALOGUE;

typedef struct {
  uint32_t total;
  uint32_t longest;
} duration;

static duration durations[FUNCTION_LIMIT];
static uint64_t sensors[EVALUATION_INPUT_LIMIT];
static uint64_t commands[EVALUATION_OUTPUT_LIMIT];

static int fits(void) {
  if (model->function_count > FUNCTION_LIMIT) return 0;
  for (int i = 0; i < model->function_count; ++i) {
    if (model->functions[i].input_size > EVALUATION_INPUT_LIMIT) return 0;
    if (model->functions[i].output_size > EVALUATION_OUTPUT_LIMIT) return 0;
  }
  return 1;
}

/* On a robot: the encoders and the force sensors. */
static void read_sensors(const sinew_function *function, uint32_t period) {
  state_draw(function, model->scalar_bytes, period, sensors);
}

static void evaluate(const sinew_function *function, duration *taken) {
  const uint32_t start = port_ticks();
  function->call(sensors, commands);
  const uint32_t ticks = port_ticks_since(start);
  taken->total += ticks;
  if (ticks > taken->longest) taken->longest = ticks;
}

/* 1 if the work of the period that began at `start` took longer than the period. */
static uint32_t wait_for_end(uint32_t start, uint32_t period_ticks) {
  if (port_ticks_since(start) > period_ticks) return 1U;
  while (port_ticks_since(start) < period_ticks) {
  }
  return 0U;
}

/* Periods follow each other from the first start, so that the rate does not drift. */
static uint32_t run(uint32_t period_ticks) {
  uint32_t overruns = 0;
  uint32_t start = port_ticks();
  for (uint32_t period = 0; period < LOOP_PERIODS; ++period) {
    for (int i = 0; i < model->function_count; ++i) {
      read_sensors(&model->functions[i], period);
      evaluate(&model->functions[i], &durations[i]);
    }
    overruns += wait_for_end(start, period_ticks);
    start += period_ticks;
  }
  return overruns;
}

static uint32_t nanoseconds(uint64_t ticks) {
  return (uint32_t)(ticks * 1000000000U / port_tick_rate());
}

static void print_duration(const char *name, const duration *taken) {
  console_text("  ");
  console_decimal(nanoseconds(taken->total) / LOOP_PERIODS);
  console_text(" ");
  console_decimal(nanoseconds(taken->longest));
  console_text(" ");
  console_text(name);
  console_text("\n");
}

static void report(uint32_t period_ticks) {
  duration together = {0, 0};
  console_text("nanoseconds a call: mean, longest\n");
  for (int i = 0; i < model->function_count; ++i) {
    print_duration(model->functions[i].name, &durations[i]);
    together.total += durations[i].total;
    together.longest += durations[i].longest;
  }
  print_duration("all together", &together);
  console_decimal(nanoseconds(period_ticks));
  console_text(" nanoseconds a period; the timer's tick is ");
  console_decimal(nanoseconds(1U));
  console_text(" nanoseconds\n");
}

int main(void) {
  if (!fits()) {
    console_text("FAIL: the model does not fit the control loop's buffers\n");
    return PORT_STATUS_DIFFERENT;
  }
  const uint32_t period_ticks = port_tick_rate() / LOOP_RATE;
  const uint32_t overruns = run(period_ticks);
  report(period_ticks);
  console_text(overruns == 0U ? "PASS: " : "FAIL: ");
  console_decimal(overruns);
  console_text(" of ");
  console_decimal(LOOP_PERIODS);
  console_text(" periods overrun at 3 kHz\n");
  return overruns == 0U ? 0 : 1;
}

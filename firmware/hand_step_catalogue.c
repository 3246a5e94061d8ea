/* SPDX-License-Identifier: BSD-2-Clause
 *
 * hand_step as a function of the catalogue, so that the comparison with the host and the counting
 * of instructions take it as they take every emitted function. The states follow each other as
 * ticks of one run; drawn samples stay so close together that no sensor counts as faulty.
 */
#include <stddef.h>

#include "hand_step.h"
#include "sinew_catalogue.h"

#define EACH_2(x) x, x
#define EACH_3(x) x, x, x
#define EACH_19(x) x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x
#define EACH_38(x) EACH_19(x), EACH_19(x)
#define RANGE(name, each, from, to)                \
  static const double name##_low[] = {each(from)}; \
  static const double name##_high[] = {each(to)}

RANGE(motor, EACH_38, -0.0049, 0.0049); /* rad; a tick may move 0.01 */
RANGE(count, EACH_38, 1500.0, 1800.0);
RANGE(wrist, EACH_2, 32400.0, 33100.0);
RANGE(gravity, EACH_3, -9.81, 9.81);
RANGE(q, EACH_19, -0.2, 0.2);
RANGE(qd, EACH_19, -1.0, 1.0);
RANGE(qdd, EACH_19, -100.0, 100.0);

static const sinew_argument inputs[] = {
    {"motor_angle", "rad", HAND_TENDONS, 1, motor_low, motor_high},
    {"lever_count", "1", HAND_TENDONS, 1, count_low, count_high},
    {"wrist_count", "1", 2, 1, wrist_low, wrist_high},
    {"gravity", "m/s^2", 3, 1, gravity_low, gravity_high},
    {"q", "rad", HAND_COORDINATES, 1, q_low, q_high},
    {"qd", "rad/s", HAND_COORDINATES, 1, qd_low, qd_high},
    {"qdd", "rad/s^2", HAND_COORDINATES, 1, qdd_low, qdd_high}};

enum {
  INPUTS = 2 * HAND_TENDONS + 2 + 3 + 3 * HAND_COORDINATES,
  OUTPUTS = offsetof(hand_output, motor_status) / sizeof(double)
};
static const sinew_argument outputs[] = {{"output", "SI", OUTPUTS, 1, 0, 0}};

static hand_state state, settled;
static hand_input input;
static hand_output output;

#define SETTLING_TICKS 60U

/* A hand at rest: once. */
static void settle(void) {
  for (uint32_t i = 0; i < HAND_TENDONS; ++i) input.lever_count[i] = 1650.0;
  for (uint32_t i = 0; i < 2U; ++i) input.wrist_count[i] = 32750.0;
  input.q[HAND_JOINTS] = hand_parameters_table.crank_reference;
  input.drive = 1U;
  (void)hand_start(&settled, &hand_parameters_table);
  for (uint32_t i = 0; i < SETTLING_TICKS; ++i)
    hand_step(&settled, &hand_parameters_table, &input, &output);
  state = settled;
}

/* The plugin leaves out what is named call_...; what it counts is hand_step. */
static void call_hand_step(const void *in, void *out) {
  const double *from = (const double *)in;
  double *to = (double *)out, *place = (double *)&input;
  const double *result = (const double *)&output;
  if (settled.ticks == 0U) settle();
  for (int i = 0; i < INPUTS; ++i) place[i] = from[i];
  input.q[HAND_JOINTS] += hand_parameters_table.crank_reference;
#ifndef HAND_STEP_RUNNING
  state = settled;
  for (uint32_t i = 1; i < hand_parameters_table.turns; ++i)
    hand_step(&state, &hand_parameters_table, &input, &output);
#endif
  hand_step(&state, &hand_parameters_table, &input, &output);
  for (int i = 0; i < OUTPUTS; ++i) to[i] = result[i];
}

static const sinew_function functions[] = {
    {"hand_step", 7, 1, INPUTS, OUTPUTS, inputs, outputs, call_hand_step}};

extern const sinew_catalogue hand_step_catalogue;
const sinew_catalogue hand_step_catalogue = {"hand_step", "", 8, 1, functions};

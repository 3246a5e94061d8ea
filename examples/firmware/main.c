/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The smallest loop around hand_step: sensors in, torques out. Here the sensors are those of a hand
 * at rest, made up; on a robot they come from the mailbox (mailbox.h) or from your own drivers.
 */
#include "console.h"
#include "hand_step.h"
#include "port.h"

#define TICKS 100U

static hand_state state;
static hand_input input;
static hand_output output;

/* Your sensors. The lowest bit of a live one is never still. */
static void read_sensors(uint32_t tick) {
  const hand_parameters *p = &hand_parameters_table;
  for (int i = 0; i < HAND_TENDONS; ++i) {
    input.motor_angle[i] = 0.0;
    input.lever_count[i] = 1400.0 + (double)(tick & 1U);
  }
  for (int i = 0; i < 2; ++i)
    input.wrist_count[i] = (p->wrist_reference[i] - p->wrist_offset[i]) / p->wrist_scale[i];
}

/* What you want: here, to stay in the reference posture. */
static void set_wanted(void) {
  input.gravity[2] = -9.81;
  input.q[HAND_JOINTS] = hand_parameters_table.crank_reference;
  input.drive = 1U;
}

/* Your motors. */
static void command_motors(void) {}

static void print_micro(double value) {
  console_text(value < 0.0 ? "-" : " ");
  console_decimal((uint32_t)(1.0e6 * (value < 0.0 ? -value : value)));
  console_text(" uN m\n");
}

int main(void) {
  if (hand_start(&state, &hand_parameters_table) != HAND_START_FINE) {
    console_text("FAIL: the table of parameters is damaged\n");
    return 1;
  }
  for (uint32_t tick = 0; tick < TICKS; ++tick) {
    const uint32_t start = port_ticks();
    read_sensors(tick);
    set_wanted();
    hand_step(&state, &hand_parameters_table, &input, &output);
    command_motors();
    while (port_ticks_since(start) < port_tick_rate() / 3000U) {
    }
  }
  for (int i = 8; i < 16; ++i) print_micro(output.motor_torque[i]);
  console_text((output.status & HAND_UNSAFE) == 0U ? "PASS\n" : "FAIL: the hand is not safe\n");
  return (output.status & HAND_UNSAFE) == 0U ? 0 : 1;
}

/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The real-time computer's side of the mailbox: one call a tick, no board in it. The program that
 * waits for frames and looks at the clock is hand_main.c.
 */
#ifndef SINEW_HAND_LOOP_H
#define SINEW_HAND_LOOP_H

#include "exchange.h"
#include "hand_step.h"
#include "mailbox.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  volatile mailbox *box;
  const hand_parameters *parameters;
  hand_state state;
  hand_input input;
  hand_output output;
  mailbox_reader reader;
  mailbox_measured measured;
  mailbox_setpoint setpoint;
  mailbox_answer answer;
} hand_loop;

enum {
  HAND_LOOP_FINE = 0,
  HAND_LOOP_TABLE = 1, /* hand_start refused the table of parameters */
  HAND_LOOP_LAYOUT = 2 /* the mailbox is not there, or of another layout */
};

/* After power-on or a reset: everything starts anew but the count of starts in the mailbox. */
int hand_loop_start(hand_loop *loop, volatile mailbox *box, const hand_parameters *parameters);

/* Looks once for a new frame and takes it. What it found. */
mailbox_reading hand_loop_look(hand_loop *loop);

/* A tick with the frame that hand_loop_look has taken, or (`late`) without one: then all sensors
 * count as missing, and the torques become 0 when that has lasted. Answers and records. */
void hand_loop_tick(hand_loop *loop, int late);

/* After a tick that took `ticks` of the board's timer; `overrun` where that is above a period. */
void hand_loop_took(hand_loop *loop, uint32_t ticks, int overrun);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: BSD-2-Clause */
#include "hand_loop.h"

#include <string.h>

int hand_loop_start(hand_loop *loop, volatile mailbox *box, const hand_parameters *parameters) {
  const int known = box->control.magic == MAILBOX_MAGIC && box->control.layout == MAILBOX_LAYOUT;
  memset(loop, 0, sizeof *loop);
  loop->box = box;
  loop->parameters = parameters;
  if (hand_start(&loop->state, parameters) != HAND_START_FINE) return HAND_LOOP_TABLE;
  if (!known) return HAND_LOOP_LAYOUT;
  loop->answer.starts = box->answer.starts + 1U;
  exchange_nothing(&loop->input);
  mailbox_write_answer(box, &loop->answer);
  return HAND_LOOP_FINE;
}

mailbox_reading hand_loop_look(hand_loop *loop) {
  const mailbox_reading found = mailbox_read_measured(loop->box, &loop->reader, &loop->measured);
  if (found == MAILBOX_NEW) exchange_measured(&loop->measured, &loop->input);
  return found;
}

void hand_loop_tick(hand_loop *loop, int late) {
  mailbox_answer *answer = &loop->answer;
  mailbox_record record;
  if (late) {
    exchange_nothing(&loop->input);
    ++answer->late;
  }
  (void)mailbox_read_setpoint(loop->box, &loop->setpoint);
  exchange_setpoint(&loop->setpoint, loop->box->control.command, &loop->input);
  hand_step(&loop->state, loop->parameters, &loop->input, &loop->output);
  exchange_answer(&loop->output, answer);
  answer->frame = answer->frame_again = loop->reader.frame;
  ++answer->heartbeat;
  answer->repeated = loop->reader.repeated;
  answer->skipped = loop->reader.skipped;
  answer->torn = loop->reader.torn;
  mailbox_write_answer(loop->box, answer);
  if (late) return;
  exchange_record(&loop->measured, &loop->output, answer, &record);
  if (!mailbox_put_record(loop->box, &record)) ++answer->lost_records;
}

void hand_loop_took(hand_loop *loop, uint32_t ticks, int overrun) {
  if (ticks > loop->answer.longest) loop->answer.longest = ticks;
  if (overrun) ++loop->answer.overruns;
}

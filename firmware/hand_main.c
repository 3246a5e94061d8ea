/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The program of the real-time computer: waits for the FPGA's frame, or until it is late, makes a
 * tick, answers, and keeps the watchdog quiet. It ends only where the mailbox tells it to (tests).
 * Status: 0; 1 where a tick took longer than a period; 2 where it could not start.
 */
#include "console.h"
#include "hand_loop.h"
#include "port.h"

#define RATE 3000U           /* Hz; must be that of the table of parameters */
#define LATE_FOURTHS 5U      /* of a period after the last frame: without a new one it is late */
#define WATCHDOG_PERIODS 30U /* 10 ms without a tick: reset */
#define STATUS_NOT_STARTED 2

static hand_loop loop;

static void print(const char *what, uint32_t value) {
  console_text("  ");
  console_text(what);
  console_text(" ");
  console_decimal(value);
  console_text("\n");
}

static void report(void) {
  const mailbox_answer *answer = &loop.answer;
  console_text("hand loop stopped\n");
  print("ticks", answer->heartbeat);
  print("starts", answer->starts);
  print("late", answer->late);
  print("repeated", answer->repeated);
  print("skipped", answer->skipped);
  print("torn", answer->torn);
  print("overruns", answer->overruns);
  print("lost records", answer->lost_records);
  print("longest tick, ns", (uint32_t)((uint64_t)answer->longest * 1000000000U / port_tick_rate()));
}

/* 1 once there is a frame; 0 where it is late; -1 where the mailbox says stop. */
static int wait_for_frame(uint32_t last, uint32_t late_ticks) {
  for (;;) {
    const uint32_t command = loop.box->control.command;
    if ((command & MAILBOX_STOP) != 0U) return -1;
    if (hand_loop_look(&loop) == MAILBOX_NEW) return 1;
    if ((command & MAILBOX_LOCKSTEP) != 0U)
      port_watchdog_kick(); /* the other side takes its time */
    else if (port_ticks_since(last) > late_ticks)
      return 0;
  }
}

static void run(uint32_t period) {
  uint32_t last = port_ticks();
  for (;;) {
    const int found = wait_for_frame(last, period / 4U * LATE_FOURTHS);
    if (found < 0) return;
    /* A late frame was expected a period after the last one: the rate does not drift. */
    const uint32_t start = port_ticks();
    last = found == 1 ? start : last + period;
    hand_loop_tick(&loop, found == 0);
    port_watchdog_kick();
    const uint32_t taken = port_ticks_since(start);
    hand_loop_took(&loop, taken, taken > period);
  }
}

int main(void) {
  const uint32_t period = port_tick_rate() / RATE;
  const int started =
      hand_loop_start(&loop, (volatile mailbox *)port_mailbox(), &hand_parameters_table);
  if (started != HAND_LOOP_FINE) {
    console_text(started == HAND_LOOP_TABLE ? "FAIL: the table of parameters is damaged\n"
                                            : "FAIL: there is no mailbox of this layout\n");
    return STATUS_NOT_STARTED;
  }
  port_watchdog_start(WATCHDOG_PERIODS * (1000000U / RATE));
  run(period);
  report();
  return loop.answer.overruns == 0U ? 0 : 1;
}

/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Starts the watchdog, keeps it quiet for a while, and stops kicking: the board has to start anew.
 * A word in memory that a reset leaves alone tells the second start from the first.
 */
#include "console.h"
#include "port.h"

#define MARK 0x57444f47U
#define KICKS 50U
#define PERIOD_US 10000U

int main(void) {
  volatile uint32_t *mark = (volatile uint32_t *)port_mailbox();
  if (*mark == MARK) {
    *mark = 0U;
    console_text("PASS: the watchdog has reset the board\n");
    return 0;
  }
  port_watchdog_start(PERIOD_US);
  for (uint32_t i = 0; i < KICKS; ++i) {
    const uint32_t start = port_ticks();
    while (port_ticks_since(start) < port_tick_rate() / 1000U) {
    }
    port_watchdog_kick();
  }
  *mark = MARK; /* a reset before this would be seen as a first start again, without end */
  console_text("50 ms with kicks, and no more\n");
  for (;;) {
  }
}

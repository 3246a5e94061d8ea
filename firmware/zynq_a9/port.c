/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Zynq-7000, Cortex-A9: Cadence UART 0 and the global timer.
 * The emulator's Cortex-A9 has no cycle counter (PMCCNTR reads 0), therefore the timer.
 */
#include "port.h"
#include "semihosting.h"

#define UART ((volatile uint32_t *)0xE0000000U)
#define UART_CONTROL 0
#define UART_STATUS 11
#define UART_FIFO 12
#define UART_ENABLE 0x14U
#define UART_FULL 0x10U

#define TIMER ((volatile uint32_t *)0xF8F00200U)
#define TIMER_LOW 0
#define TIMER_CONTROL 2
/* The emulator's peripheral clock. On the chip it is half the core's clock (333 MHz at 667 MHz). */
#define TIMER_RATE 100000000U

void port_init(void) {
  UART[UART_CONTROL] = UART_ENABLE;
  TIMER[TIMER_CONTROL] = 1U;
}

void port_put_character(char character) {
  while ((UART[UART_STATUS] & UART_FULL) != 0U) {
  }
  UART[UART_FIFO] = (uint32_t)(unsigned char)character;
}

uint32_t port_ticks(void) { return TIMER[TIMER_LOW]; }
uint32_t port_ticks_since(uint32_t start) { return port_ticks() - start; }
uint32_t port_tick_rate(void) { return TIMER_RATE; }
_Noreturn void port_exit(int status) { semihosting_exit(status); }

/* The last MiB of the emulator's 128: behind what board.ld gives to the image. On the chip: the
 * FPGA's window, in memory that is mapped as not cached. */
volatile void *port_mailbox(void) { return (volatile void *)0x07F00000U; }

/* The core's private watchdog. The emulator lets it run, but does not reset. */
#define WATCHDOG ((volatile uint32_t *)0xF8F00620U)
#define WATCHDOG_LOAD 0
#define WATCHDOG_CONTROL 2
#define WATCHDOG_MODE 9U /* watchdog, enabled, without prescaler */

static uint32_t watchdog_load;

void port_watchdog_start(uint32_t microseconds) {
  watchdog_load = microseconds * (TIMER_RATE / 1000000U);
  WATCHDOG[WATCHDOG_LOAD] = watchdog_load;
  WATCHDOG[WATCHDOG_CONTROL] = WATCHDOG_MODE;
}

void port_watchdog_kick(void) { WATCHDOG[WATCHDOG_LOAD] = watchdog_load; }

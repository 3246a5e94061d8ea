/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Zynq UltraScale+, Cortex-R5F of the real-time unit: Cadence UART 0 and the core's cycle counter.
 */
#include "port.h"
#include "semihosting.h"

#define UART ((volatile uint32_t *)0xFF000000U)
#define UART_CONTROL 0
#define UART_STATUS 11
#define UART_FIFO 12
#define UART_ENABLE 0x14U
#define UART_FULL 0x10U

/* One instruction is one nanosecond and one cycle in the emulator. On the chip: the core's clock.
 */
#define CYCLE_RATE 1000000000U

void port_init(void) {
  UART[UART_CONTROL] = UART_ENABLE;
  __asm__ volatile("mcr p15, 0, %0, c9, c12, 0" ::"r"(5U));       /* PMCR: enable, reset cycles */
  __asm__ volatile("mcr p15, 0, %0, c9, c12, 1" ::"r"(1U << 31)); /* PMCNTENSET: cycle counter */
}

void port_put_character(char character) {
  while ((UART[UART_STATUS] & UART_FULL) != 0U) {
  }
  UART[UART_FIFO] = (uint32_t)(unsigned char)character;
}

uint32_t port_ticks(void) {
  uint32_t cycles;
  __asm__ volatile("mrc p15, 0, %0, c9, c13, 0" : "=r"(cycles)); /* PMCCNTR */
  return cycles;
}

uint32_t port_ticks_since(uint32_t start) { return port_ticks() - start; }
uint32_t port_tick_rate(void) { return CYCLE_RATE; }
_Noreturn void port_exit(int status) { semihosting_exit(status); }

/* The last MiB of the emulator's 128: behind what board.ld gives to the image. On the chip: the
 * FPGA's window, in memory that the protection unit has as not cached. */
volatile void *port_mailbox(void) { return (volatile void *)0x07F00000U; }

/* The system watchdog of the low-power domain is not in the emulator: here there is none. */
void port_watchdog_start(uint32_t microseconds) { (void)microseconds; }
void port_watchdog_kick(void) {}

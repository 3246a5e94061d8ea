/* SPDX-License-Identifier: BSD-2-Clause
 *
 * All that a board gives to the programs in this folder. A new board is one folder with a port.c
 * that defines these, and a linker script board.ld.
 */
#ifndef SINEW_PORT_H
#define SINEW_PORT_H

#include <stdint.h>

#define PORT_STATUS_EQUAL 0
#define PORT_STATUS_DIFFERENT 1
#define PORT_STATUS_FAULT 99

/* Called once before main, with the memory initialised and the FPU on. */
void port_init(void);

/* Sends one character; waits while the transmitter is full. */
void port_put_character(char character);

/* A free-running timer that counts up, and its rate in ticks a second. It may have fewer than 32
 * bits (at least 24), therefore only port_ticks_since tells differences; it takes port_ticks() or
 * port_ticks() + n, n ticks ahead. */
uint32_t port_ticks(void);
uint32_t port_ticks_since(uint32_t start);
uint32_t port_tick_rate(void);

/* Where the memory lies that the FPGA sees, too (mailbox.h); not initialised by the start-up. */
volatile void *port_mailbox(void);

/* From the start on the processor is reset unless the watchdog is kicked every so often. Where a
 * board has none, or the emulator none that resets, both do nothing; port.c says so. */
void port_watchdog_start(uint32_t microseconds);
void port_watchdog_kick(void);

/* Ends the program; the debugger or emulator gets the status. */
_Noreturn void port_exit(int status);

#endif

/* SPDX-License-Identifier: BSD-2-Clause
 *
 * MPS2 with image AN500, Cortex-M7 with a double-precision FPU: CMSDK UART 0 and SysTick.
 * The emulator has no DWT cycle counter; on hardware it would be the better timer.
 */
#include "port.h"
#include "semihosting.h"

#define UART ((volatile uint32_t *)0x40004000U)
#define UART_DATA 0
#define UART_STATE 1
#define UART_CONTROL 2
#define UART_DIVIDER 4
#define UART_FULL 1U

#define TIMER ((volatile uint32_t *)0xE000E010U)
#define TIMER_CONTROL 0
#define TIMER_RELOAD 1
#define TIMER_VALUE 2
#define TIMER_MASK 0xFFFFFFU
#define TIMER_RATE 25000000U

extern char image_stack_top[];
_Noreturn void start_program(void);
void reset(void);
void fault(void);

/* The FPU is off after reset: it is switched on before any C runs that may use it. */
__attribute__((naked)) void reset(void) {
  __asm__ volatile(
      "ldr r0, =0xE000ED88\n" /* CPACR */
      "ldr r1, [r0]\n"
      "orr r1, r1, #0xF00000\n"
      "str r1, [r0]\n"
      "dsb\n"
      "isb\n"
      "b start_program\n"
      ".ltorg");
}

void fault(void) { port_exit(PORT_STATUS_FAULT); }

/* The watchdog's warning; its reset follows. */
static void wait_for_reset(void) {
  for (;;) {
  }
}

typedef union {
  char *stack;
  void (*handler)(void);
} vector;

extern const vector vectors[16];
__attribute__((section(".vectors"), used)) const vector vectors[16] = {{.stack = image_stack_top},
                                                                       {.handler = reset},
                                                                       {.handler = wait_for_reset},
                                                                       {.handler = fault},
                                                                       {.handler = fault},
                                                                       {.handler = fault},
                                                                       {.handler = fault},
                                                                       {.handler = 0},
                                                                       {.handler = 0},
                                                                       {.handler = 0},
                                                                       {.handler = 0},
                                                                       {.handler = fault},
                                                                       {.handler = fault},
                                                                       {.handler = 0},
                                                                       {.handler = fault},
                                                                       {.handler = fault}};

void port_init(void) {
  UART[UART_DIVIDER] = 16U;
  UART[UART_CONTROL] = 1U;
  TIMER[TIMER_RELOAD] = TIMER_MASK;
  TIMER[TIMER_VALUE] = 0U;
  TIMER[TIMER_CONTROL] = 5U; /* processor clock, enabled */
  while (TIMER[TIMER_VALUE] == 0U) {
  }
}

void port_put_character(char character) {
  while ((UART[UART_STATE] & UART_FULL) != 0U) {
  }
  UART[UART_DATA] = (uint32_t)(unsigned char)character;
}

/* SysTick counts down and has 24 bits. */
uint32_t port_ticks(void) { return TIMER_MASK - TIMER[TIMER_VALUE]; }
uint32_t port_ticks_since(uint32_t start) { return (port_ticks() - start) & TIMER_MASK; }
uint32_t port_tick_rate(void) { return TIMER_RATE; }
_Noreturn void port_exit(int status) { semihosting_exit(status); }

/* The board's PSRAM, which the image does not use. */
volatile void *port_mailbox(void) { return (volatile void *)0x60000000U; }

/* The CMSDK's watchdog: at 0 the interrupt that cannot be masked, and a reset at the next 0. */
#define WATCHDOG ((volatile uint32_t *)0x40008000U)
#define WATCHDOG_LOAD 0
#define WATCHDOG_CONTROL 2
#define WATCHDOG_CLEAR 3
#define WATCHDOG_LOCK 0x300
#define WATCHDOG_KEY 0x1ACCE551U

void port_watchdog_start(uint32_t microseconds) {
  WATCHDOG[WATCHDOG_LOCK] = WATCHDOG_KEY;
  WATCHDOG[WATCHDOG_LOAD] = microseconds * (TIMER_RATE / 1000000U) / 2U;
  WATCHDOG[WATCHDOG_CONTROL] = 3U; /* counts, and resets */
}

void port_watchdog_kick(void) { WATCHDOG[WATCHDOG_CLEAR] = 1U; }

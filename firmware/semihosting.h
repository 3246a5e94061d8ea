/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The one semihosting call used: leave with a status. Text goes through the UART, as on hardware.
 */
#ifndef SINEW_SEMIHOSTING_H
#define SINEW_SEMIHOSTING_H

/* SYS_EXIT cannot carry a status on a 32-bit Arm; SYS_EXIT_EXTENDED takes a block of two words. */
#define SEMIHOSTING_EXIT_EXTENDED 0x20
#define SEMIHOSTING_APPLICATION_EXIT 0x20026

static inline _Noreturn void semihosting_exit(int status) {
  const int block[2] = {SEMIHOSTING_APPLICATION_EXIT, status};
  register int operation __asm__("r0") = SEMIHOSTING_EXIT_EXTENDED;
  register const int *argument __asm__("r1") = block;
#if __ARM_ARCH_PROFILE == 'M'
  __asm__ volatile("bkpt 0xab" : "+r"(operation) : "r"(argument) : "memory");
#elif defined(__thumb__)
  __asm__ volatile("svc 0xab" : "+r"(operation) : "r"(argument) : "memory", "lr");
#else
  __asm__ volatile("svc 0x123456" : "+r"(operation) : "r"(argument) : "memory", "lr");
#endif
  for (;;) {
  }
}

#endif

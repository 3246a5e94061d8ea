/* SPDX-License-Identifier: BSD-2-Clause
 *
 * The part of the start-up that is C and the same on every board.
 */
#include <stddef.h>
#include <string.h>

#include "port.h"

/* Defined by the linker script; only their addresses mean something. */
extern char image_data_load[], image_data_start[], image_data_end[];
extern char image_bss_start[], image_bss_end[];

int main(void);
_Noreturn void start_program(void);

_Noreturn void start_program(void) {
  if (&image_data_load[0] != &image_data_start[0]) {
    memcpy(image_data_start, image_data_load, (size_t)(image_data_end - image_data_start));
  }
  memset(image_bss_start, 0, (size_t)(image_bss_end - image_bss_start));
  port_init();
  port_exit(main());
}

/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Executes an undefined instruction: shows that a fault ends the image with PORT_STATUS_FAULT.
 */
#include "console.h"
#include "port.h"

int main(void) {
  console_text("executing an undefined instruction\n");
  __asm__ volatile("udf #0");
  return PORT_STATUS_EQUAL;
}

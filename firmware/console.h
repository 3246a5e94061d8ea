/* SPDX-License-Identifier: BSD-2-Clause
 *
 * Text on the board's UART without printf: no heap, no locale, the same bytes on every board.
 */
#ifndef SINEW_CONSOLE_H
#define SINEW_CONSOLE_H

#include <stdint.h>

void console_text(const char *text);
void console_decimal(uint32_t value);
void console_hexadecimal(uint64_t value); /* 16 digits */

#endif

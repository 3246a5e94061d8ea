/* SPDX-License-Identifier: BSD-2-Clause */
#include "console.h"

#include "port.h"

void console_text(const char *text) {
  for (; *text != '\0'; ++text) {
    port_put_character(*text);
  }
}

void console_decimal(uint32_t value) {
  char digits[11];
  int first = 10;
  digits[first] = '\0';
  do {
    digits[--first] = (char)('0' + (int)(value % 10U));
    value /= 10U;
  } while (value != 0U);
  console_text(&digits[first]);
}

void console_hexadecimal(uint64_t value) {
  for (int shift = 60; shift >= 0; shift -= 4) {
    port_put_character("0123456789abcdef"[(value >> shift) & 15U]);
  }
}

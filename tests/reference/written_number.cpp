// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/written_number.h"

#include <charconv>
#include <stdexcept>
#include <string>

namespace sinew::reference {
namespace {

std::string shortest_decimal(double value) {
  char text[64];
  const std::to_chars_result written = std::to_chars(text, text + sizeof text, value);
  if (written.ec != std::errc()) throw std::invalid_argument("a number too long to write");
  return {text, written.ptr};
}

}  // namespace

template <>
double written_number(double value) {
  return value;
}

template <>
long double written_number(double value) {
  const std::string text = shortest_decimal(value);
  long double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

template <>
Real50 written_number(double value) {
  return Real50(shortest_decimal(value));
}

}  // namespace sinew::reference

// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/literal.h"

#include <charconv>

namespace sinew {

std::string literal(double value, const Target& target) {
  char text[40];
  const std::to_chars_result end =
      target.scalar == Scalar::binary64
          ? std::to_chars(text, text + sizeof text, value)
          : std::to_chars(text, text + sizeof text, static_cast<float>(value));
  std::string result(text, end.ptr);
  if (result.find_first_of(".e") == std::string::npos) result += ".0";
  return result + target.suffix();
}

}  // namespace sinew

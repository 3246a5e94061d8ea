// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/literal.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

namespace sinew {

std::string literal(double value, const Target& target) {
  const bool finite = target.scalar == Scalar::binary64
                          ? std::isfinite(value)
                          : std::isfinite(static_cast<float>(value));
  if (!finite)
    throw std::range_error(
        fmt::format("the constant {} is too large for {}; expected a smaller value in the model, or "
                    "another unit",
                    value, target.type()));
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

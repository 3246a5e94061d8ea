// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/origin.h"

#include <fmt/format.h>

#include <algorithm>

namespace sinew {

const std::vector<std::string>& origins() {
  static const std::vector<std::string> words{"text",     "assumed",    "cad",
                                              "measured", "identified", "urdf"};
  return words;
}

bool is_origin(std::string_view word) {
  return std::find(origins().begin(), origins().end(), word) != origins().end();
}

std::string origin_words() {
  return fmt::format("{}", fmt::join(origins(), ", "));
}

}  // namespace sinew

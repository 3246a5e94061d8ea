// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs that show at once whether a folder is whole: every file is full of one letter.
#pragma once

#include "generator/write.h"

namespace sinew {

/// Six files, one in a folder of its own; `size` bytes in the largest, so that its writing takes a
/// while.
inline FileSet lettered_files(char letter, std::size_t size = 200000) {
  const std::string manifest =
      R"({"files": ["a.c", "b.h", "c.c", "d.h", "host/e.c", "manifest.json"], "letter": ")" +
      std::string(1, letter) + "\"}\n";
  return {{"a.c", std::string(size, letter)},     {"b.h", std::string(7, letter)},
          {"c.c", std::string(size / 3, letter)}, {"d.h", std::string(size / 7, letter)},
          {"host/e.c", std::string(5, letter)},   {"manifest.json", manifest}};
}

}  // namespace sinew

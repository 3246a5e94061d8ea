// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/read_text.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace sinew {

std::string read_text(const std::filesystem::path& path, Findings& findings,
                      std::uintmax_t most_bytes) {
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(path, ignored);
  if (is_file) {
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (size > most_bytes) {
      findings.add({path.string(), 0, 0}, fmt::format("holds {} bytes", size),
                   fmt::format("expected at most {}", most_bytes));
      return "";
    }
  }
  std::ifstream stream;
  if (is_file) stream.open(path, std::ios::binary);
  std::ostringstream text;
  if (stream.is_open() && stream.peek() != std::ifstream::traits_type::eof())
    text << stream.rdbuf();
  if (!stream.is_open() || stream.bad() || text.fail())  // read to its end, too
    findings.add({path.string(), 0, 0}, "cannot be read", "expected a readable file");
  return text.str();
}

}  // namespace sinew

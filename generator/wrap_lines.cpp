// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/wrap_lines.h"

#include <cstddef>

namespace sinew {
namespace {

constexpr std::size_t most_columns = 100;

/// Where a line may end: the last blank before the margin, after a comma or before an operator if
/// there is one; npos where it has none.
std::size_t break_of(const std::string& line, std::size_t indent, bool comment) {
  std::size_t any = std::string::npos, good = std::string::npos;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size() && i <= most_columns; ++i) {
    if (line[i] == '"' && !comment) quoted = !quoted;
    const bool closes = line.compare(i + 1, std::string::npos, "*/") == 0;
    if (line[i] != ' ' || i <= indent || quoted || closes) continue;
    any = i;
    const bool operation = i + 2 < line.size() && line[i + 2] == ' ' &&
                           std::string("+-*/=?:").find(line[i + 1]) != std::string::npos;
    if (comment || line[i - 1] == ',' || operation) good = i;
  }
  return good == std::string::npos || good < most_columns / 2 ? any : good;
}

std::string wrapped(std::string line, bool comment) {
  std::string text;
  const std::size_t first = line.find_first_not_of(' ');
  if (first == std::string::npos || line[first] == '#') return line;
  const std::string next = comment ? " *     " : std::string(first + 4, ' ');
  std::size_t indent = comment ? 8 : first;
  while (line.size() > most_columns) {
    const std::size_t at = break_of(line, indent, comment);
    if (at == std::string::npos) break;
    text += line.substr(0, at) + "\n";
    line = next + line.substr(at + 1);
    indent = next.size();
  }
  return text + line;
}

}  // namespace

std::string wrap_lines(const std::string& text) {
  std::string all;
  bool comment = false;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    const std::string line = text.substr(start, end - start);
    const bool opens = line.rfind("/*", 0) == 0;
    comment = comment || opens;
    all += wrapped(line, comment);
    if (line.find("*/") != std::string::npos) comment = false;
    if (end == std::string::npos) break;
    all += '\n';
    start = end + 1;
  }
  return all;
}

}  // namespace sinew

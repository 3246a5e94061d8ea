// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/readable.h"

#include <fmt/format.h>

#include <algorithm>

#include "symbolic/files/limits.h"

namespace sinew {
namespace {

/// One character of UTF-8; size 0 where the bytes are none.
struct Utf8Character {
  char32_t code = 0;
  std::size_t size = 0;
};

unsigned byte_at(std::string_view text, std::size_t at) {
  return static_cast<unsigned char>(text[at]);
}

/// Strict: neither longer than need be, nor a surrogate, nor beyond U+10FFFF.
Utf8Character first_character(std::string_view text) {
  const unsigned lead = byte_at(text, 0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t size = lead >= 0xC2 && lead < 0xE0   ? 2
                           : lead >= 0xE0 && lead < 0xF0 ? 3
                           : lead >= 0xF0 && lead < 0xF5 ? 4
                                                         : 0;
  if (size == 0 || text.size() < size) return {};
  char32_t code = lead & (0xFFu >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte_at(text, i) & 0xC0u) != 0x80u) return {};
    code = (code << 6) | (byte_at(text, i) & 0x3Fu);
  }
  const bool too_long = (size == 3 && code < 0x800) || (size == 4 && code < 0x10000);
  if (too_long || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
  return {code, size};
}

bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

/// Marks of direction, line and paragraph separators, the byte order mark.
bool is_layout(char32_t code) {
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

std::string escaped_but(std::string_view text, std::string_view kept) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Utf8Character next = first_character(text.substr(at));
    if (next.size == 0) {
      result += fmt::format("\\x{:02x}", byte_at(text, at++));
      continue;
    }
    const bool is_kept = next.size == 1 && kept.find(text[at]) != std::string_view::npos;
    if (!is_kept && next.code == '\n')
      result += "\\n";
    else if (!is_kept && next.code == '\t')
      result += "\\t";
    else if (!is_kept && (is_control(next.code) || is_layout(next.code)))
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(next.code));
    else
      result += text.substr(at, next.size);
    at += next.size;
  }
  return result;
}

/// The nearest place at or before `at` that is not inside a character.
std::size_t character_start(std::string_view text, std::size_t at) {
  for (int i = 0; i < 3 && at > 0 && at < text.size() && (byte_at(text, at) & 0xC0u) == 0x80u; ++i)
    --at;
  return at;
}

}  // namespace

std::string readable(std::string_view text) {
  return escaped_but(text, "\n\t");
}

std::string readable_line(std::string_view text) {
  return escaped_but(text, "");
}

std::string shortened(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return std::string(text);
  const std::size_t end = character_start(text, longest * 2 / 3),
                    again = character_start(text, text.size() - longest / 6);
  return fmt::format("{} ... ({} bytes left out) ... {}", text.substr(0, end), again - end,
                     text.substr(again));
}

std::string message_part(std::string_view text) {
  return readable_line(shortened(text, limits::shown_characters));
}

std::string message_lines(std::string_view text) {
  std::string lines;
  // The list of mistakes and a heading.
  constexpr std::size_t most_lines = 2 * limits::shown_mistakes;
  for (std::size_t at = 0, count = 0; at <= text.size(); ++count) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (count == most_lines) {
      const auto left =
          std::count(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), '\n');
      return lines + fmt::format("\n... and {} more lines", left + 1);
    }
    lines +=
        (at == 0 ? "" : "\n") + readable(shortened(text.substr(at, end - at), limits::shown_line));
    at = end + 1;
  }
  return lines;
}

std::string listed(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), limits::shown_names);
  std::string text;
  for (std::size_t i = 0; i < shown; ++i)
    text += (i == 0 ? "" : ", ") + shortened(names[i], limits::shown_characters / 4);
  if (shown < names.size()) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/identifier.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace sinew {
namespace {

constexpr std::size_t longest_name = 63;  // significant initial characters C11 guarantees

// C11 and C++20 keywords and alternative tokens.
const std::set<std::string_view>& keywords() {
  static const std::set<std::string_view> words{"alignas",
                                                "alignof",
                                                "and",
                                                "and_eq",
                                                "asm",
                                                "auto",
                                                "bitand",
                                                "bitor",
                                                "bool",
                                                "break",
                                                "case",
                                                "catch",
                                                "char",
                                                "char8_t",
                                                "char16_t",
                                                "char32_t",
                                                "class",
                                                "compl",
                                                "concept",
                                                "const",
                                                "consteval",
                                                "constexpr",
                                                "constinit",
                                                "const_cast",
                                                "continue",
                                                "co_await",
                                                "co_return",
                                                "co_yield",
                                                "decltype",
                                                "default",
                                                "delete",
                                                "do",
                                                "double",
                                                "dynamic_cast",
                                                "else",
                                                "enum",
                                                "explicit",
                                                "export",
                                                "extern",
                                                "false",
                                                "float",
                                                "for",
                                                "friend",
                                                "goto",
                                                "if",
                                                "inline",
                                                "int",
                                                "long",
                                                "mutable",
                                                "namespace",
                                                "new",
                                                "noexcept",
                                                "not",
                                                "not_eq",
                                                "nullptr",
                                                "operator",
                                                "or",
                                                "or_eq",
                                                "private",
                                                "protected",
                                                "public",
                                                "register",
                                                "reinterpret_cast",
                                                "requires",
                                                "restrict",
                                                "return",
                                                "short",
                                                "signed",
                                                "sizeof",
                                                "static",
                                                "static_assert",
                                                "static_cast",
                                                "struct",
                                                "switch",
                                                "template",
                                                "this",
                                                "thread_local",
                                                "throw",
                                                "true",
                                                "try",
                                                "typedef",
                                                "typeid",
                                                "typename",
                                                "union",
                                                "unsigned",
                                                "using",
                                                "virtual",
                                                "void",
                                                "volatile",
                                                "wchar_t",
                                                "while",
                                                "xor",
                                                "xor_eq",
                                                "main",
                                                "errno",
                                                "real",
                                                "NULL"};
  return words;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
      diagonal = above;
    }
  }
  return row[b.size()];
}

}  // namespace

std::optional<std::string> why_not_identifier(std::string_view name) {
  if (name.empty()) return "is empty";
  if (name.size() > longest_name)
    return fmt::format("has {} characters, more than {}", name.size(), longest_name);
  for (const char c : name)
    if (!is_letter(c) && !is_digit(c) && c != '_')
      return "has a character other than a letter, a digit or an underscore";
  if (is_digit(name[0])) return "starts with a digit";
  if (name[0] == '_') return "starts with an underscore, which is reserved";
  if (name.find("__") != std::string_view::npos) return "has two underscores, which is reserved";
  if (keywords().contains(name)) return "is a word of C or C++, or one the emitted code uses";
  return std::nullopt;
}

std::string_view identifier_rule() {
  return "expected an identifier: a letter, then letters, digits and single underscores";
}

std::string make_identifier(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (is_letter(c) || is_digit(c))
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) name = "unnamed";
  if (is_digit(name[0])) name.insert(0, "n");
  if (name.size() > longest_name) name.resize(longest_name);
  if (keywords().contains(name)) name += "_1";
  return name;
}

std::string nearest(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t distance = std::max<std::size_t>(1, std::min<std::size_t>(name.size(), 60) / 3) + 1;
  if (name.size() > 2 * longest_name) return best;
  for (const std::string& candidate : candidates) {
    const std::size_t here = edit_distance(name, candidate);
    if (here < distance) {
      distance = here;
      best = candidate;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates) {
  const std::string best = nearest(name, candidates);
  return best.empty() ? "" : fmt::format(" (did you mean '{}'?)", best);
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/files/identifier.h"

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

/// Letters added, left out, changed, or swapped with their neighbour.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t far = a.size() + b.size();
  std::vector<std::vector<std::size_t>> d(a.size() + 1,
                                          std::vector<std::size_t>(b.size() + 1, far));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
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
  if (name.size() > longest_name) return best;
  std::size_t distance = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t here =
        candidate.size() > longest_name ? distance : edit_distance(name, candidate);
    if (here < distance && here < name.size()) {
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

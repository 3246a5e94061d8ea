// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/units.h"

#include <cctype>
#include <cmath>
#include <numbers>
#include <vector>

namespace sinew {
namespace {

using std::numbers::pi;

struct Symbol {
  std::string_view text;
  Unit unit;
  bool takes_prefix;
};

// Exponents: m, kg, s, A, K, rad.
const std::vector<Symbol>& symbols() {
  static const std::vector<Symbol> table = {
      {"m", {1.0, {1, 0, 0, 0, 0, 0}}, true},
      {"g", {1.0e-3, {0, 1, 0, 0, 0, 0}}, true},
      {"s", {1.0, {0, 0, 1, 0, 0, 0}}, true},
      {"A", {1.0, {0, 0, 0, 1, 0, 0}}, true},
      {"K", {1.0, {0, 0, 0, 0, 1, 0}}, true},
      {"rad", {1.0, {0, 0, 0, 0, 0, 1}}, true},
      {"N", {1.0, {1, 1, -2, 0, 0, 0}}, true},
      {"V", {1.0, {2, 1, -3, -1, 0, 0}}, true},
      {"W", {1.0, {2, 1, -3, 0, 0, 0}}, true},
      {"J", {1.0, {2, 1, -2, 0, 0, 0}}, true},
      {"Pa", {1.0, {-1, 1, -2, 0, 0, 0}}, true},
      {"Hz", {1.0, {0, 0, -1, 0, 0, 0}}, true},
      {"deg", {pi / 180.0, {0, 0, 0, 0, 0, 1}}, true},
      {"degree", {pi / 180.0, {0, 0, 0, 0, 0, 1}}, false},
      {"degrees", {pi / 180.0, {0, 0, 0, 0, 0, 1}}, false},
      {"rev", {2.0 * pi, {0, 0, 0, 0, 0, 1}}, false},
      {"turn", {2.0 * pi, {0, 0, 0, 0, 0, 1}}, false},
      {"turns", {2.0 * pi, {0, 0, 0, 0, 0, 1}}, false},
      {"rpm", {pi / 30.0, {0, 0, -1, 0, 0, 1}}, false},
      {"sec", {1.0, {0, 0, 1, 0, 0, 0}}, true},
      {"second", {1.0, {0, 0, 1, 0, 0, 0}}, false},
      {"seconds", {1.0, {0, 0, 1, 0, 0, 0}}, false},
      {"min", {60.0, {0, 0, 1, 0, 0, 0}}, false},
      {"h", {3600.0, {0, 0, 1, 0, 0, 0}}, false},
      {"inch", {0.0254, {1, 0, 0, 0, 0, 0}}, false},
      {"lbf", {4.4482216152605, {1, 1, -2, 0, 0, 0}}, false},
      {"kgf", {9.80665, {1, 1, -2, 0, 0, 0}}, false},
      {"%", {0.01, {}}, false},
      {"1", {1.0, {}}, false},
      {"-", {1.0, {}}, false},
      {"count", {1.0, {}}, false},
      {"counts", {1.0, {}}, false},
      {"inc", {1.0, {}}, false},
      {"increments", {1.0, {}}, false},
      {"tick", {1.0, {}}, false},
      {"ticks", {1.0, {}}, false},
      {"lsb", {1.0, {}}, false},
  };
  return table;
}

std::optional<double> prefix_factor(char letter) {
  switch (letter) {
    case 'G':
      return 1.0e9;
    case 'M':
      return 1.0e6;
    case 'k':
      return 1.0e3;
    case 'd':
      return 1.0e-1;
    case 'c':
      return 1.0e-2;
    case 'm':
      return 1.0e-3;
    case 'u':
      return 1.0e-6;
    case 'n':
      return 1.0e-9;
    default:
      return std::nullopt;
  }
}

std::optional<Unit> known_symbol(std::string_view text) {
  for (const Symbol& symbol : symbols())
    if (symbol.text == text) return symbol.unit;
  if (text.size() < 2) return std::nullopt;
  const std::optional<double> factor = prefix_factor(text.front());
  if (!factor) return std::nullopt;
  for (const Symbol& symbol : symbols())
    if (symbol.takes_prefix && symbol.text == text.substr(1)) {
      Unit unit = symbol.unit;
      unit.factor *= *factor;
      return unit;
    }
  return std::nullopt;
}

Unit product(const Unit& a, const Unit& b, int power) {
  Unit result = a;
  result.factor *= std::pow(b.factor, power);
  for (size_t i = 0; i < result.dimension.size(); ++i)
    result.dimension[i] += power * b.dimension[i];
  return result;
}

// "Nmm" is newton times millimetre: written without a separator, split where both halves are known.
std::optional<Unit> symbol_or_run(std::string_view text, int power) {
  if (const auto unit = known_symbol(text)) return product(Unit{}, *unit, power);
  for (size_t cut = text.size() - 1; cut > 0; --cut) {
    const auto left = known_symbol(text.substr(0, cut));
    if (!left) continue;
    if (const auto right = symbol_or_run(text.substr(cut), power)) return product(*right, *left, 1);
  }
  return std::nullopt;
}

struct Replacement {
  std::string_view from, to;
};

// UTF-8 spellings first; what remains above 0x7f is read as Latin-1.
constexpr Replacement replacements[] = {
    {"\xC2\xB7", "*"},      {"\xE2\x8B\x85", "*"},  {"\xC3\x97", "*"},
    {"\xC2\xB5", "u"},      {"\xCE\xBC", "u"},      {"\xC2\xB0", "deg"},
    {"\xC2\xBA", "deg"},    {"\xC2\xB2", "^2"},     {"\xC2\xB3", "^3"},
    {"\xC2\xB9", "^1"},     {"\xE2\x81\xBB", "^-"}, {"\xE2\x88\x92", "-"},
    {"\xE2\x81\xB4", "^4"}, {"\xC2\xA0", " "},      {"**", "^"},
    {"\xB7", "*"},          {"\xB5", "u"},          {"\xB0", "deg"},
    {"\xB2", "^2"},         {"\xB3", "^3"},
};

std::string plain(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    bool replaced = false;
    for (const Replacement& r : replacements)
      if (text.substr(i).starts_with(r.from)) {
        // A raised minus is followed by a raised digit: "⁻¹" is one exponent.
        const bool joins = out.ends_with("^-") && r.to.starts_with("^");
        out += joins ? r.to.substr(1) : r.to;
        i += r.from.size();
        replaced = true;
        break;
      }
    if (!replaced) out += text[i++];
  }
  return out;
}

class UnitParser {
 public:
  explicit UnitParser(std::string text) : text_(std::move(text)) {}

  std::optional<Unit> parse() {
    Unit result;
    int sign = 1;
    bool any = false;
    while (skip_separators(sign)) {
      const auto next = factor(sign);
      if (!next) return std::nullopt;
      result = product(result, *next, 1);
      any = true;
    }
    return any && !dangling_ ? std::optional(result) : std::nullopt;
  }

 private:
  // A quotient's right side reaches to the next operator: "N*m/rad*s" divides by rad alone.
  bool skip_separators(int& sign) {
    sign = 1;
    bool operator_seen = false;
    while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) != 0 ||
                                  text_[at_] == '*' || text_[at_] == '/' || text_[at_] == '.')) {
      if (text_[at_] == '/') sign = -1;
      operator_seen = operator_seen || text_[at_] == '/' || text_[at_] == '*';
      ++at_;
    }
    if (at_ >= text_.size()) {
      dangling_ = operator_seen;
      return false;
    }
    return true;
  }

  std::optional<Unit> factor(int sign) {
    const size_t begin = at_;
    if (text_[at_] == '1' || text_[at_] == '%' || text_[at_] == '-') {
      ++at_;
      return known_symbol(std::string_view(text_).substr(begin, 1));
    }
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    if (at_ == begin) return std::nullopt;
    const size_t end = at_;
    const std::optional<int> power = exponent();
    if (!power) return std::nullopt;
    const std::string_view letters = std::string_view(text_).substr(begin, end - begin);
    if (*power == 1) return symbol_or_run(letters, sign);
    return run_with_power(letters, *power, sign);
  }

  // "kgm2": the exponent belongs to the last symbol of the run.
  static std::optional<Unit> run_with_power(std::string_view letters, int power, int sign) {
    if (const auto unit = known_symbol(letters)) return product(Unit{}, *unit, sign * power);
    for (size_t cut = letters.size() - 1; cut > 0; --cut) {
      const auto last = known_symbol(letters.substr(cut));
      const auto first = symbol_or_run(letters.substr(0, cut), sign);
      if (last && first) return product(*first, *last, sign * power);
    }
    return std::nullopt;
  }

  std::optional<int> exponent() {
    bool caret = false;
    if (at_ < text_.size() && text_[at_] == '^') {
      caret = true;
      ++at_;
    }
    int sign = 1;
    if (at_ < text_.size() && text_[at_] == '-') {
      sign = -1;
      ++at_;
    }
    if (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0)
      return sign * (text_[at_++] - '0');
    if (caret || sign < 0) return std::nullopt;
    return 1;
  }

  std::string text_;
  size_t at_ = 0;
  bool dangling_ = false;
};

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::optional<Unit> parse_unit(std::string_view text) {
  return UnitParser(plain(trimmed(text))).parse();
}

bool convertible(const Unit& given, const Unit& wanted) {
  const bool with_mass = wanted.dimension[1] != 0;
  const size_t compared = with_mass ? 5 : 6;
  for (size_t i = 0; i < compared; ++i)
    if (given.dimension[i] != wanted.dimension[i]) return false;
  return true;
}

NameAndUnit split_name_and_unit(std::string_view cell) {
  cell = trimmed(cell);
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')}) {
    if (cell.empty() || cell.back() != close) continue;
    const size_t at = cell.rfind(open);
    if (at == std::string_view::npos) continue;
    const std::string_view unit = trimmed(cell.substr(at + 1, cell.size() - at - 2));
    return {std::string(trimmed(cell.substr(0, at))), std::string(unit)};
  }
  return {std::string(cell), ""};
}

std::optional<NameAndUnit> split_unit_suffix(std::string_view name) {
  const size_t at = name.rfind('_');
  if (at == std::string_view::npos || at == 0 || at + 1 == name.size()) return std::nullopt;
  const std::string_view suffix = name.substr(at + 1);
  if (std::isdigit(static_cast<unsigned char>(suffix.front())) != 0) return std::nullopt;
  if (!parse_unit(suffix)) return std::nullopt;
  return NameAndUnit{std::string(name.substr(0, at)), std::string(suffix)};
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string_view>

#include "symbolic/notation/typeset.h"

namespace sinew {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 34> kGreek = {{
    {"alpha", "α"},  {"beta", "β"},   {"gamma", "γ"}, {"delta", "δ"},   {"epsilon", "ε"},
    {"zeta", "ζ"},   {"eta", "η"},    {"theta", "θ"}, {"iota", "ι"},    {"kappa", "κ"},
    {"lambda", "λ"}, {"mu", "μ"},     {"nu", "ν"},    {"xi", "ξ"},      {"pi", "π"},
    {"rho", "ρ"},    {"sigma", "σ"},  {"tau", "τ"},   {"upsilon", "υ"}, {"phi", "φ"},
    {"chi", "χ"},    {"psi", "ψ"},    {"omega", "ω"}, {"Gamma", "Γ"},   {"Delta", "Δ"},
    {"Theta", "Θ"},  {"Lambda", "Λ"}, {"Xi", "Ξ"},    {"Pi", "Π"},      {"Sigma", "Σ"},
    {"Phi", "Φ"},    {"Psi", "Ψ"},    {"Omega", "Ω"}, {"Upsilon", "Υ"},
}};

std::string_view greek(std::string_view name) {
  const auto* found = std::find_if(kGreek.begin(), kGreek.end(),
                                   [&](const auto& entry) { return entry.first == name; });
  return found == kGreek.end() ? std::string_view{} : found->second;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

/// Underscores become blanks that do not break.
std::string spaced(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '_' ? "\u00a0" : escaped(std::string_view(&c, 1));
  return result;
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

struct Parts {
  std::string_view head, below;
  std::size_t dots = 0;
};

/// "q20" and "q_20" have the same parts; "level_change" has no subscript.
Parts parts_of(std::string_view name) {
  Parts parts{name, {}, 0};
  const std::size_t letters = std::min(name.find_first_of("0123456789_"), name.size());
  const std::string_view head = name.substr(0, letters);
  std::string_view rest = name.substr(letters);
  if (!rest.empty() && rest.front() == '_') rest.remove_prefix(1);
  const std::size_t ds = head.size() > 1 && head.front() == 'q' ? head.size() - 1 : 0;
  const bool dotted = ds > 0 && ds <= 4 && head.find_first_not_of('d', 1) == std::string_view::npos;
  const bool letter = head.size() == 1 || !greek(head).empty() || dotted;
  if (!letter && !is_number(rest)) return parts;
  parts.head = dotted ? head.substr(0, 1) : head;
  parts.dots = dotted ? ds : 0;
  parts.below = rest;
  return parts;
}

bool is_word(const Parts& parts) {
  return parts.head.size() > 1 && greek(parts.head).empty();
}

std::string typeset_parts(const Parts& parts) {
  static constexpr std::array<const char*, 5> dots = {"", "˙", "¨", "...", "...."};
  const std::string_view letter = greek(parts.head);
  std::string text = "<mi>" + (letter.empty() ? spaced(parts.head) : std::string(letter)) + "</mi>";
  // Not as an accent: fonts without a table for mathematics would put the dots into the letter.
  if (parts.dots) text = "<mover>" + text + "<mo>" + dots[parts.dots] + "</mo></mover>";
  if (parts.below.empty()) return text;
  const bool number = is_number(parts.below);
  const std::string_view below = greek(parts.below);
  const std::string content = below.empty() ? spaced(parts.below) : std::string(below);
  return "<msub>" + text + (number ? "<mn>" + content + "</mn>" : "<mi>" + content + "</mi>") +
         "</msub>";
}

/// Letters of LaTeX's text mode; underscores become blanks.
std::string latex_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '_')
      result += "\\ ";
    else if (std::string_view("#$%&{}").find(c) != std::string_view::npos)
      result += std::string("\\") + c;
    else if (c != '\\' && c != '^' && c != '~')
      result += c;
  }
  return result;
}

/// A Greek letter's command, a letter, or a word set upright.
std::string latex_word(std::string_view word) {
  if (!greek(word).empty()) return "\\" + std::string(word);
  return word.size() == 1 || is_number(word) ? latex_text(word)
                                             : "\\mathrm{" + latex_text(word) + "}";
}

std::string latex_parts(const Parts& parts) {
  static constexpr std::array<const char*, 5> dots = {"", "\\dot", "\\ddot", "\\dddot", "\\ddddot"};
  std::string text = latex_word(parts.head);
  if (parts.dots) text = std::string(dots[parts.dots]) + "{" + text + "}";
  return parts.below.empty() ? text : text + "_{" + latex_word(parts.below) + "}";
}

}  // namespace

std::string latex_name(const std::string& name) {
  return latex_parts(parts_of(name));
}

std::string mathml_name(const std::string& name) {
  return typeset_parts(parts_of(name));
}

Typeset typeset_symbol(const std::string& name, const MathNames& names) {
  const auto other = names.find(name);
  const std::string& shown = other == names.end() ? name : other->second;
  const Parts parts = parts_of(shown);
  return {typeset_parts(parts), shown, Binding::atom, is_word(parts), latex_parts(parts)};
}

}  // namespace sinew

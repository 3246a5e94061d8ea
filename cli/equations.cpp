// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/equations.h"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "symbolic/equations/equations.h"

namespace sinew {
namespace {

EquationFormat format_named(const std::string& name) {
  if (name == "latex") return EquationFormat::latex;
  if (name == "mathml") return EquationFormat::mathml;
  if (name == "text") return EquationFormat::text;
  throw std::invalid_argument(fmt::format("--format {}: expected latex, mathml or text", name));
}

std::optional<EquationPage> page_of(const ModelFolder& folder) {
  if (const auto* mechanism = std::get_if<Mechanism>(&folder.model))
    return mechanism_equations(*mechanism);
  if (const auto* part = std::get_if<Part>(&folder.model)) {
    if (const auto* wrist = std::get_if<WristParameters>(&part->parameters))
      return wrist_equations(*wrist);
    if (std::holds_alternative<EffectLibrary>(part->parameters)) return effect_equations();
  }
  return std::nullopt;
}

std::string folded_html(const std::string& summary, const EquationPage& page, bool open) {
  return fmt::format("<details{}><summary>{}</summary><div class=\"inside\">{}</div></details>\n",
                     open ? " open" : "", summary, html_sections(page, 4, true));
}

}  // namespace

std::string equations_of(const ModelFolder& folder, const std::string& format) {
  const EquationFormat as = format_named(format);
  if (const std::optional<EquationPage> page = page_of(folder)) return printed(*page, as);
  throw std::invalid_argument(
      fmt::format("{}: --equations knows mechanisms, a wrist and the effects; of a hand, ask for "
                  "each of its fingers and the wrist",
                  folder.folder.string()));
}

std::string equations_html(const ModelFolder& folder) {
  if (const std::optional<EquationPage> page = page_of(folder))
    return html_sections(*page, 3, true);
  const auto* hand = std::get_if<Hand>(&folder.model);
  if (!hand) return "";
  std::string text;
  for (const HandFinger& finger : hand->fingers)
    text += folded_html(finger.mechanism.name, mechanism_equations(finger.mechanism), false);
  return text + folded_html("wrist", wrist_equations(hand->wrist), false);
}

}  // namespace sinew

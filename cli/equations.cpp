// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/equations.h"

#include <fmt/format.h>

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

EquationPage page_of(const ModelFolder& folder) {
  if (const auto* mechanism = std::get_if<Mechanism>(&folder.model))
    return mechanism_equations(*mechanism);
  if (const auto* part = std::get_if<Part>(&folder.model)) {
    if (const auto* wrist = std::get_if<WristParameters>(&part->parameters))
      return wrist_equations(*wrist);
    if (std::holds_alternative<EffectLibrary>(part->parameters)) return effect_equations();
  }
  throw std::invalid_argument(
      fmt::format("{}: --equations knows mechanisms, a wrist and the effects; of a hand, ask for "
                  "each of its fingers and the wrist",
                  folder.folder.string()));
}

}  // namespace

std::string equations_of(const ModelFolder& folder, const std::string& format) {
  const EquationFormat as = format_named(format);
  return printed(page_of(folder), as);
}

}  // namespace sinew

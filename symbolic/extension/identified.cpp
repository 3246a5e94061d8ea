// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/identified.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sinew {
namespace {

/// A basic string of TOML; names of files may hold any byte.
std::string in_quotes(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      quoted += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      quoted += c;
  }
  return quoted + "\"";
}

void append(const std::vector<IdentifiedValue>& values, const char* key, std::string& text) {
  for (const IdentifiedValue& v : values)
    text += fmt::format(
        "[[effect.{}]]\nname = \"{}\"\nvalue = {}\nstandard_error = {}\nunit = \"{}\"\n", key,
        v.name, v.value, v.standard_error, v.unit);
}

}  // namespace

double IdentifiedEffect::coefficient(const std::string& name) const {
  for (const IdentifiedValue& v : coefficients)
    if (v.name == name) return v.value;
  throw std::invalid_argument("effect '" + effect + "' has no coefficient '" + name + "'");
}

std::string identified_text(const Identified& identified) {
  std::string text =
      "# SPDX-License-Identifier: BSD-2-Clause\n"
      "# What measurements taught about this model; read by sinew generate. Delete an [[effect]] "
      "to\n"
      "# take it back.\n";
  for (const IdentifiedLog& log : identified.logs)
    text += fmt::format("\n[[log]]\nfile = {}\nsha256 = \"{}\"\n", in_quotes(log.file), log.sha256);
  for (const auto& [joint, constant] : identified.torque_constants)
    text += fmt::format("\n[[torque_constant]]\njoint = {}\nvalue = {}  # {}\n", in_quotes(joint),
                        constant, "effort of 1 A [N*m/A, N/A] with which currents were read");
  for (const IdentifiedEffect& effect : identified.effects) {
    text +=
        fmt::format("\n[[effect]]\neffect = \"{}\"\nplace = \"{}\"\n", effect.effect, effect.place);
    append(effect.shape, "shape", text);
    append(effect.coefficients, "coefficient", text);
  }
  return text;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/identified.h"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "symbolic/effects/effects.h"
#include "symbolic/extension/identified_mechanism.h"
#include "symbolic/extension/observation.h"
#include "symbolic/files/read_text.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {
namespace {

/// Reads one file; every mistake is reported with its place.
class IdentifiedReader {
 public:
  explicit IdentifiedReader(const Observation* observation) : observation_(observation) {}

  Identified read(TomlTable root) {
    Identified result;
    for (TomlTable& table : root.tables("log")) {
      result.logs.push_back(
          {table.text("file", true).value_or(""), table.text("sha256", true).value_or("")});
      table.finish();
    }
    for (TomlTable& table : root.tables("effect")) result.effects.push_back(effect(table));
    root.finish();
    return result;
  }

 private:
  IdentifiedEffect effect(TomlTable& table) {
    IdentifiedEffect result;
    result.effect = table.text("effect", true).value_or("");
    result.place = table.text("place", true).value_or("");
    for (TomlTable& each : table.tables("shape")) result.shape.push_back(value(each));
    for (TomlTable& each : table.tables("coefficient")) result.coefficients.push_back(value(each));
    check(table, result);
    table.finish();
    return result;
  }

  IdentifiedValue value(TomlTable& table) {
    IdentifiedValue result;
    result.name = table.text("name", true).value_or("");
    result.value = number(table, "value");
    result.standard_error = table.has("standard_error") ? number(table, "standard_error") : 0.0;
    result.unit = table.text("unit", true).value_or("");
    table.finish();
    return result;
  }

  double number(TomlTable& table, const char* key) {
    const auto found = table.number(key);
    return found.value_or(0.0);
  }

  /// The names have to be those of the effect, all of them.
  void check(TomlTable& table, const IdentifiedEffect& read) {
    if (observation_) return check_observed(table, read);
    if (read.effect == "delay" || read.effect == "direction" || read.effect == "torque_constant" ||
        read.effect == "pulley_radius" || changes_mechanism(read))
      return;
    try {
      const Effect& effect = find_effect(read.effect);
      same_names(table, read.effect, effect.shapes, read.shape, "shape");
      same_names(table, read.effect, effect.columns, read.coefficients, "coefficient");
    } catch (const std::invalid_argument& error) {
      table.report("effect", error.what(), "expected an effect of the catalogue");
    }
  }

  void check_observed(TomlTable& table, const IdentifiedEffect& read) {
    const ObservationEffect* effect = find_effect(*observation_, read.effect, read.place);
    if (!effect) {
      std::string known;
      for (const ObservationEffect& each : observation_->effects)
        known += fmt::format("{}{} at '{}'", known.empty() ? "" : ", ", each.id, each.place);
      table.report("effect", fmt::format("no effect '{}' at '{}'", read.effect, read.place),
                   "expected one of " + known);
      return;
    }
    same_names(table, read.effect, effect->shapes, read.shape, "shape");
    same_names(table, read.effect, effect->deviations, read.coefficients, "coefficient");
  }

  template <class Declared>
  static void same_names(TomlTable& table, const std::string& effect,
                         const std::vector<Declared>& declared,
                         const std::vector<IdentifiedValue>& given, const char* key) {
    bool fits = declared.size() == given.size();
    std::string expected;
    for (std::size_t i = 0; i < declared.size(); ++i) {
      expected += (i ? ", " : "") + declared[i].name;
      fits = fits && given[i].name == declared[i].name;
    }
    if (!fits)
      table.report(key, fmt::format("{} has other values than '{}'", table.path(), effect),
                   "expected " + (expected.empty() ? "none" : expected));
  }

  const Observation* observation_;  ///< of a rig; nullptr for what is driven
};

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

Identified read_identified(const std::filesystem::path& folder, const Observation* observation) {
  const std::filesystem::path path = folder / "identified.toml";
  if (!std::filesystem::exists(path)) return {};
  Findings findings;
  const std::string name = path.string();
  const std::string text = read_text(name, findings);
  findings.raise_if_any();
  std::map<std::string, std::string> provenance;
  TomlFile file{name, findings, provenance};
  const toml::table root = parse_toml(text, file);
  findings.raise_if_any();
  Identified result = IdentifiedReader(observation).read(TomlTable(root, "", file));
  findings.raise_if_any();
  return result;
}

std::string identified_text(const Identified& identified) {
  std::string text =
      "# SPDX-License-Identifier: BSD-2-Clause\n"
      "# What measurements taught about this model; read by sinew generate. Delete an [[effect]] "
      "to\n"
      "# take it back.\n";
  for (const IdentifiedLog& log : identified.logs)
    text += fmt::format("\n[[log]]\nfile = \"{}\"\nsha256 = \"{}\"\n", log.file, log.sha256);
  for (const IdentifiedEffect& effect : identified.effects) {
    text +=
        fmt::format("\n[[effect]]\neffect = \"{}\"\nplace = \"{}\"\n", effect.effect, effect.place);
    append(effect.shape, "shape", text);
    append(effect.coefficients, "coefficient", text);
  }
  return text;
}

}  // namespace sinew

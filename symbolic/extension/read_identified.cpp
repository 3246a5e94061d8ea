// SPDX-License-Identifier: GPL-3.0-or-later
// identified.toml as its effects declare it: names, places, units and limits.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "symbolic/extension/identified.h"
#include "symbolic/extension/learnt_entry.h"
#include "symbolic/extension/observation.h"
#include "symbolic/files/identifier.h"
#include "symbolic/files/read_text.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {
namespace {

std::string range_text(const ValueLimits& limits) {
  const bool low = std::isfinite(limits.low), high = std::isfinite(limits.high);
  const std::string least =
      fmt::format("{} {:.6g}", limits.above_low ? "above" : "at least", limits.low);
  if (low && high) return fmt::format("{} and at most {:.6g}", least, limits.high);
  return low ? least : fmt::format("at most {:.6g}", limits.high);
}

/// In the unit that is wanted; nothing where it measures something else.
std::optional<double> converted(double value, const std::string& unit, const std::string& wanted) {
  if (same_spelling(unit, wanted)) return value;
  const std::optional<MeasureUnit> given = find_unit(unit), asked = find_unit(wanted);
  if (!given || !asked || given->dimension != asked->dimension) return std::nullopt;
  return to_si(value, *given);
}

/// Reads one file; every mistake is reported with its place.
class IdentifiedReader {
 public:
  IdentifiedReader(const Observation* observation, const LearntPlaces* places)
      : observation_(observation), places_(places) {}

  Identified read(TomlTable root) {
    Identified result;
    for (TomlTable& table : root.tables("log")) result.logs.push_back(log(table));
    for (TomlTable& table : root.tables("torque_constant"))
      torque_constant(table, result.torque_constants);
    for (TomlTable& table : root.tables("effect")) {
      IdentifiedEffect entry = effect(table);
      refuse_second(table, entry, result.effects);
      result.effects.push_back(std::move(entry));
    }
    root.finish();
    return result;
  }

 private:
  static IdentifiedLog log(TomlTable& table) {
    IdentifiedLog log{table.text("file", true).value_or(""), ""};
    const std::optional<std::string> hash = table.text("sha256", true);
    const char* digits = "0123456789abcdef";
    if (hash && (hash->size() != 64 || hash->find_first_not_of(digits) != std::string::npos))
      table.report("sha256", fmt::format("{}.sha256 is no SHA-256 sum", table.path()),
                   "expected 64 hexadecimal digits");
    log.sha256 = hash.value_or("");
    table.finish();
    return log;
  }

  static void torque_constant(TomlTable& table, std::map<std::string, double>& constants) {
    const std::string joint = table.text("joint", true).value_or("");
    const std::optional<double> value = table.number("value");
    table.finish();
    if (value && !(*value > 0.0))
      table.report("value", fmt::format("{}.value is {}", table.path(), *value),
                   "expected the effort of 1 A at the joint, above 0");
    if (!constants.emplace(joint, value.value_or(0.0)).second)
      table.report("joint", fmt::format("{} gives '{}' a second time", table.path(), joint),
                   "expected it once");
  }

  IdentifiedEffect effect(TomlTable& table) {
    IdentifiedEffect result;
    result.effect = table.text("effect", true).value_or("");
    result.place = table.text("place", true).value_or("");
    result.where = table.where("effect");
    const std::optional<DeclaredEntry> declared = declaration(table, result);
    std::vector<TomlTable> shapes = table.tables("shape"),
                           coefficients = table.tables("coefficient");
    if (declared) {
      result.shape = values(table, "shape", shapes, declared->shapes, *declared);
      result.coefficients =
          values(table, "coefficient", coefficients, declared->coefficients, *declared);
    }
    table.finish();
    return result;
  }

  std::optional<DeclaredEntry> declaration(TomlTable& table, const IdentifiedEffect& read) {
    if (read.effect.empty() || read.place.empty()) return std::nullopt;
    if (observation_) return observed(table, read);
    const std::vector<std::string> known = declared_effects();
    if (std::find(known.begin(), known.end(), read.effect) == known.end()) {
      table.report("effect",
                   fmt::format("{} is the unknown effect '{}'{}", table.path(), read.effect,
                               did_you_mean(read.effect, known)),
                   fmt::format("expected one of: {}", fmt::join(known, ", ")));
      return std::nullopt;
    }
    if (!places_) return declared_entry(read.effect);
    const LearntPlace* place = place_of(table, read);
    return place ? declared_entry(read.effect, place->revolute) : std::nullopt;
  }

  std::optional<DeclaredEntry> observed(TomlTable& table, const IdentifiedEffect& read) const {
    std::optional<DeclaredEntry> entry = declared_entry(*observation_, read.effect, read.place);
    if (entry) return entry;
    std::vector<std::string> known;
    for (const ObservationEffect& each : observation_->effects)
      known.push_back(fmt::format("{} at '{}'", each.id, each.place));
    table.report("effect", fmt::format("no effect '{}' at '{}'", read.effect, read.place),
                 fmt::format("expected one of {}", fmt::join(known, ", ")));
    return std::nullopt;
  }

  const LearntPlace* place_of(TomlTable& table, const IdentifiedEffect& read) const {
    const PlaceKind kind = declared_entry(read.effect)->place;
    std::vector<std::string> names;
    for (const LearntPlace& place : *places_) {
      if (place.kind != kind) continue;
      if (place.name == read.place) return &place;
      names.push_back(place.name);
    }
    table.report("place",
                 fmt::format("{}.place: '{}' cannot be at '{}'{}", table.path(), read.effect,
                             read.place, did_you_mean(read.place, names)),
                 names.empty() ? std::string("this model has no place for it")
                               : fmt::format("expected one of: {}", fmt::join(names, ", ")));
    return nullptr;
  }

  /// In the order in which they are declared.
  std::vector<IdentifiedValue> values(TomlTable& entry, const char* key,
                                      std::vector<TomlTable>& tables,
                                      const std::vector<DeclaredValue>& declared,
                                      const DeclaredEntry& of) {
    std::vector<std::string> names;
    for (const DeclaredValue& each : declared) names.push_back(each.name);
    std::map<std::string, IdentifiedValue> read;
    for (TomlTable& table : tables) {
      const std::string name = table.text("name", true).value_or("");
      const auto at = std::find(names.begin(), names.end(), name);
      if (at == names.end()) {
        if (!name.empty()) report_unknown(table, name, names);
        continue;
      }
      if (read.count(name))
        table.report("name", fmt::format("{} gives '{}' a second time", entry.path(), name),
                     "expected it once");
      read[name] = value(table, declared[static_cast<std::size_t>(at - names.begin())], of);
    }
    std::vector<IdentifiedValue> result;
    for (const DeclaredValue& each : declared) {
      if (const auto found = read.find(each.name); found != read.end())
        result.push_back(found->second);
      else if (each.before)
        result.push_back({each.name, *each.before, 0.0, each.unit});
      else if (each.required)
        entry.report(key, fmt::format("{} has no {} '{}'", entry.path(), key, each.name),
                     fmt::format("expected {} [{}]", each.name, each.unit));
    }
    return result;
  }

  static void report_unknown(TomlTable& table, const std::string& name,
                             const std::vector<std::string>& names) {
    table.report(
        "name",
        fmt::format("{} is the unknown '{}'{}", table.path(), name, did_you_mean(name, names)),
        names.empty() ? std::string("expected none")
                      : fmt::format("expected one of: {}", fmt::join(names, ", ")));
  }

  IdentifiedValue value(TomlTable& table, const DeclaredValue& declared, const DeclaredEntry& of) {
    IdentifiedValue result;
    result.name = declared.name;
    result.unit = declared.unit;
    const std::optional<double> given = table.number("value");
    const double error =
        table.has("standard_error") ? table.number("standard_error").value_or(0.0) : 0.0;
    const std::optional<std::string> unit = table.text("unit", true);
    table.finish();
    if (error < 0.0)
      table.report("standard_error", fmt::format("{}.standard_error is {}", table.path(), error),
                   "expected 0 or more");
    if (!given || !unit) return result;
    std::optional<double> si = converted(*given, *unit, declared.unit);
    if (!si && !declared.or_unit.empty()) {
      result.unit = declared.or_unit;
      si = converted(*given, *unit, result.unit);
    }
    if (!si) {
      table.report("unit",
                   fmt::format("{}: '{}' has the unit '{}'", table.path(), declared.name, *unit),
                   fmt::format("expected {}", declared.unit));
      return result;
    }
    result.value = *si;
    result.standard_error = *converted(error, *unit, result.unit);
    if (!declared.limits.hold(*si) || !std::isfinite(result.standard_error))
      table.report("value",
                   fmt::format("{}: '{}' is {:.6g} {}{}", table.path(), declared.name, *si,
                               result.unit, of.limit.empty() ? "" : ": " + of.limit),
                   fmt::format("expected {}", range_text(declared.limits)));
    return result;
  }

  void refuse_second(TomlTable& table, const IdentifiedEffect& entry,
                     const std::vector<IdentifiedEffect>& before) const {
    const std::optional<DeclaredEntry> declared =
        observation_ ? declared_entry(*observation_, entry.effect, entry.place)
                     : declared_entry(entry.effect);
    if (!declared) return;
    const auto same = [&](const IdentifiedEffect& other) {
      const auto equal = [](const auto& a, const auto& b) { return a.value == b.value; };
      return other.effect == entry.effect && other.place == entry.place &&
             (declared->single || std::equal(other.shape.begin(), other.shape.end(),
                                             entry.shape.begin(), entry.shape.end(), equal));
    };
    const auto first = std::find_if(before.begin(), before.end(), same);
    if (first != before.end())
      table.report("effect",
                   fmt::format("'{}' at '{}' is there a second time, first in line {}",
                               entry.effect, entry.place, first->where.line),
                   "expected one entry with the sum of both");
  }

  const Observation* observation_;  ///< of a rig; nullptr for what is driven
  const LearntPlaces* places_;      ///< of what is driven; nullptr: not known
};

Identified parse_entries(const std::string& text, const std::string& name,
                         const Observation* observation, const LearntPlaces* places) {
  Findings findings;
  std::map<std::string, std::string> provenance;
  TomlFile file{name, findings, provenance};
  const toml::table root = parse_toml(text, file);
  findings.raise_if_any();
  Identified result = IdentifiedReader(observation, places).read(TomlTable(root, "", file));
  findings.raise_if_any();
  return result;
}

Identified read_entries(const std::filesystem::path& folder, const Observation* observation,
                        const LearntPlaces* places) {
  const std::filesystem::path path = folder / "identified.toml";
  if (!std::filesystem::exists(path)) return {};
  Findings findings;
  const std::string text = read_text(path, findings);
  findings.raise_if_any();
  return parse_entries(text, path.string(), observation, places);
}

}  // namespace

Identified read_identified(const std::filesystem::path& folder, const Observation* observation) {
  return read_entries(folder, observation, nullptr);
}

Identified read_identified(const std::filesystem::path& folder, const LearntPlaces& places) {
  return read_entries(folder, nullptr, &places);
}

Identified parse_identified(const std::string& text, const std::string& name,
                            const Observation& observation) {
  return parse_entries(text, name, &observation, nullptr);
}

Identified parse_identified(const std::string& text, const std::string& name,
                            const LearntPlaces& places) {
  return parse_entries(text, name, nullptr, &places);
}

}  // namespace sinew

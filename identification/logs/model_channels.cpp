// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/model_channels.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "identification/logs/units.h"
#include "symbolic/files/read_text.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {
namespace {

constexpr const char* kExpected = "expected channel = \"column name [unit]\" or \"#3 [unit]\"";

bool is_given(const std::vector<std::string>& given, const std::string& channel) {
  return std::any_of(given.begin(), given.end(),
                     [&](const std::string& text) { return text.starts_with(channel + "="); });
}

/// What channels.toml says.
struct Told {
  std::vector<std::string> lines;           ///< of [channels], as texts of --map
  std::map<std::string, double> constants;  ///< of [torque_constants], by joint
};

void take_channel(std::string_view channel, const toml::node& column, const TomlFile& file,
                  Told& told) {
  if (const toml::value<std::string>* text = column.as_string())
    told.lines.push_back(std::string(channel) + "=" + text->get());
  else
    file.findings.add(locate(file, column.source()),
                      "channels." + std::string(channel) + " is no text", kExpected);
}

void take_constant(std::string_view joint, const toml::node& value, const TomlFile& file,
                   Told& told) {
  const double number = value.value<double>().value_or(0.0);
  if (std::isfinite(number) && number > 0.0)
    told.constants[std::string(joint)] = number;
  else
    file.findings.add(locate(file, value.source()),
                      "torque_constants." + std::string(joint) + " is no number above 0",
                      "expected the effort of 1 A at the joint, in N*m/A or N/A");
}

Told told_by(const toml::table& root, const TomlFile& file) {
  Told told;
  for (const auto& [key, node] : root) {
    const bool channels = key.str() == "channels", constants = key.str() == "torque_constants";
    const toml::table* table = channels || constants ? node.as_table() : nullptr;
    if (!table) {
      file.findings.add(locate(file, node.source()), "'" + std::string(key.str()) + "' is unknown",
                        "expected the tables [channels], [torque_constants]");
      continue;
    }
    for (const auto& [name, value] : *table)
      (channels ? take_channel : take_constant)(name.str(), value, file, told);
  }
  return told;
}

/// Nothing where the model has no such file.
Told read_channels(const std::filesystem::path& model_folder) {
  const std::filesystem::path path = model_folder / "channels.toml";
  if (!std::filesystem::exists(path)) return {};
  Findings findings;
  const std::string text = read_text(path.string(), findings);
  findings.raise_if_any();
  std::map<std::string, std::string> provenance;
  const TomlFile file{path.string(), findings, provenance};
  Told told = told_by(parse_toml(text, file), file);
  findings.raise_if_any();
  return told;
}

}  // namespace

std::vector<std::string> mapped_channels(const std::filesystem::path& model_folder,
                                         const std::vector<std::string>& given) {
  std::vector<std::string> all = given;
  for (std::string& line : read_channels(model_folder).lines)
    if (!is_given(given, line.substr(0, line.find('=')))) all.push_back(std::move(line));
  return all;
}

std::map<std::string, double> torque_constants(const std::filesystem::path& model_folder,
                                               const std::vector<std::string>& given) {
  std::map<std::string, double> constants = read_channels(model_folder).constants;
  for (const std::string& text : given) {
    const std::size_t at = text.find('=');
    const std::string joint(trimmed(std::string_view(text).substr(0, at)));
    double value = 0.0;
    const char* begin = text.data() + (at == std::string::npos ? text.size() : at + 1);
    const auto parsed = std::from_chars(begin, text.data() + text.size(), value);
    if (joint.empty() || parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() ||
        !std::isfinite(value) || !(value > 0.0))
      throw std::invalid_argument("--torque-constant '" + text +
                                  "': expected joint=VALUE, the effort of 1 A at the joint in "
                                  "N*m/A or N/A, above 0");
    constants[joint] = value;
  }
  return constants;
}

}  // namespace sinew

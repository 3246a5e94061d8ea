// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/model_channels.h"

#include <algorithm>

#include "symbolic/files/read_text.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {
namespace {

constexpr const char* kExpected = "expected channel = \"column name [unit]\" or \"#3 [unit]\"";

bool is_given(const std::vector<std::string>& given, const std::string& channel) {
  return std::any_of(given.begin(), given.end(),
                     [&](const std::string& text) { return text.starts_with(channel + "="); });
}

/// The lines of [channels].
std::vector<std::string> lines_of(const toml::table& root, const TomlFile& file) {
  std::vector<std::string> lines;
  for (const auto& [key, node] : root) {
    const toml::table* channels = key.str() == "channels" ? node.as_table() : nullptr;
    if (!channels) {
      file.findings.add(locate(file, node.source()), "'" + std::string(key.str()) + "' is unknown",
                        "expected the table [channels]");
      continue;
    }
    for (const auto& [channel, column] : *channels)
      if (const toml::value<std::string>* text = column.as_string())
        lines.push_back(std::string(channel.str()) + "=" + text->get());
      else
        file.findings.add(locate(file, column.source()),
                          "channels." + std::string(channel.str()) + " is no text", kExpected);
  }
  return lines;
}

std::vector<std::string> read_channels(const std::string& name) {
  Findings findings;
  const std::string text = read_text(name, findings);
  findings.raise_if_any();
  std::map<std::string, std::string> provenance;
  const TomlFile file{name, findings, provenance};
  std::vector<std::string> lines = lines_of(parse_toml(text, file), file);
  findings.raise_if_any();
  return lines;
}

}  // namespace

std::vector<std::string> mapped_channels(const std::filesystem::path& model_folder,
                                         const std::vector<std::string>& given) {
  const std::filesystem::path path = model_folder / "channels.toml";
  std::vector<std::string> all = given;
  if (!std::filesystem::exists(path)) return all;
  for (std::string& line : read_channels(path.string()))
    if (!is_given(given, line.substr(0, line.find('=')))) all.push_back(std::move(line));
  return all;
}

}  // namespace sinew

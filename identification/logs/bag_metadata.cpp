// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <stdexcept>

#include "identification/logs/bag_folder.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

constexpr std::string_view kTable = "rosbag2_bagfile_information:";

struct YamlLine {
  long number = 0;
  std::size_t indent = 0;
  std::string_view text;  ///< without indent, comment lines and what is blank at its end
};

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::vector<YamlLine> lines_of(std::string_view text) {
  std::vector<YamlLine> lines;
  for (long number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = without_blanks(text.substr(0, end));
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent != std::string_view::npos && line[indent] != '#' && line != "---")
      lines.push_back({number, indent, line.substr(indent)});
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

/// Values of the table's own keys, and what stands below them.
class MetadataTable {
 public:
  MetadataTable(std::string_view text, const std::string& path) : path_(path) {
    const std::vector<YamlLine> lines = lines_of(text);
    auto at = std::find_if(lines.begin(), lines.end(), [](const YamlLine& line) {
      return line.indent == 0 && line.text == kTable;
    });
    if (at == lines.end() || ++at == lines.end() || at->indent == 0)
      fail(1, fmt::format("has no table {}", kTable.substr(0, kTable.size() - 1)));
    const std::size_t indent = at->indent;
    for (std::string* key = nullptr; at != lines.end() && at->indent > 0; ++at) {
      const bool own = at->indent == indent && !at->text.starts_with("- ");
      if (own)
        key = &begin_key(*at);
      else if (key)
        below_[*key].push_back(*at);
    }
  }

  std::string scalar(const std::string& key, const std::optional<std::string>& otherwise = {}) {
    const auto found = values_.find(key);
    if (found == values_.end() && otherwise) return *otherwise;
    if (found == values_.end()) fail(1, fmt::format("has no key {}", key));
    return unquoted_scalar(found->second);
  }

  std::vector<std::string> list(const std::string& key) {
    const auto found = values_.find(key);
    if (found == values_.end()) fail(1, fmt::format("has no key {}", key));
    if (!found->second.text.empty() || below_[key].empty())
      fail(found->second.number, fmt::format("'{}' is no list of one item a line", key));
    std::vector<std::string> items;
    for (YamlLine item : below_[key]) {
      if (!item.text.starts_with("- "))
        fail(item.number, fmt::format("'{}' has an item without a dash", key));
      item.text.remove_prefix(2);
      items.push_back(unquoted_scalar(item));
    }
    return items;
  }

  long number(const std::string& key) {
    const std::string text = scalar(key);
    long value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size())
      fail(values_.at(key).number, fmt::format("'{}' is no whole number", key));
    return value;
  }

 private:
  std::string& begin_key(const YamlLine& line) {
    const std::size_t colon = line.text.find(':');
    if (colon == std::string_view::npos) fail(line.number, "has a line without a key");
    key_ = std::string(line.text.substr(0, colon));
    const std::string_view rest = line.text.substr(colon + 1);
    const std::size_t begin = std::min(rest.find_first_not_of(' '), rest.size());
    if (!values_.try_emplace(key_, YamlLine{line.number, line.indent, rest.substr(begin)}).second)
      fail(line.number, fmt::format("has the key '{}' twice", readable_line(key_)));
    return key_;
  }

  /// Plain, or in quotes without escapes; "" where nothing or ~ stands.
  std::string unquoted_scalar(const YamlLine& line) {
    std::string_view text = line.text;
    if (text == "~") return "";
    const char quote = text.empty() ? '\0' : text.front();
    const bool quoted = quote == '"' || quote == '\'';
    if (quoted) {
      if (text.size() < 2 || text.back() != quote) fail(line.number, "has an open quote");
      text = text.substr(1, text.size() - 2);
    }
    const char* unread = quoted ? "\"'\\" : "\"'\\[]{}&*!|>#";
    if (text.find_first_of(unread) != std::string_view::npos)
      fail(line.number, "has a value that is no plain text");
    return std::string(text);
  }

  [[noreturn]] void fail(long line, const std::string& what) const {
    throw std::runtime_error(
        fmt::format("{}:{}:0: {}; expected what rosbag2 writes: ros2 bag reindex writes it anew",
                    readable_line(path_), line, what));
  }

  std::string path_, key_;
  std::map<std::string, YamlLine> values_;
  std::map<std::string, std::vector<YamlLine>> below_;
};

}  // namespace

BagMetadata parse_bag_metadata(std::string_view text, const std::string& path) {
  MetadataTable table(text, path);
  BagMetadata data;
  data.version = table.number("version");
  data.storage = table.scalar("storage_identifier");
  data.compression = table.scalar("compression_mode", "");
  for (char& c : data.compression)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  data.compressed_by = table.scalar("compression_format", "");
  data.files = table.list("relative_file_paths");
  return data;
}

}  // namespace sinew

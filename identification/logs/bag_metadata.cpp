// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

#include "identification/logs/bag_folder.h"
#include "symbolic/files/readable.h"

#if __has_include(<yaml-cpp/yaml.h>)
#include <yaml-cpp/yaml.h>
#endif

namespace sinew {
namespace {

[[noreturn]] void refuse_metadata(const std::string& path, int line, const std::string& what) {
  throw std::runtime_error(
      fmt::format("{}:{}:0: {}; expected what rosbag2 writes: ros2 bag reindex writes it anew",
                  readable_line(path), line, what));
}

}  // namespace

#if __has_include(<yaml-cpp/yaml.h>)
namespace {

int line_of(const YAML::Node& node) {
  return node.Mark().is_null() ? 1 : node.Mark().line + 1;
}

/// The value of one key of the table; refused where it is of another type.
template <typename T>
T value_of(const YAML::Node& table, const std::string& key, const std::string& path) {
  const YAML::Node node = table[key];
  if (!node) refuse_metadata(path, line_of(table), fmt::format("has no key {}", key));
  try {
    return node.as<T>();
  } catch (const YAML::Exception&) {
    refuse_metadata(path, line_of(node), fmt::format("'{}' is not of its type", key));
  }
}

std::string text_or_nothing(const YAML::Node& table, const std::string& key,
                            const std::string& path) {
  const YAML::Node node = table[key];
  return !node || node.IsNull() ? std::string() : value_of<std::string>(table, key, path);
}

}  // namespace

BagMetadata parse_bag_metadata(const std::string& text, const std::string& path) {
  YAML::Node all;
  try {
    all = YAML::Load(text);
  } catch (const YAML::Exception& wrong) {
    refuse_metadata(path, wrong.mark.is_null() ? 1 : wrong.mark.line + 1, "is no YAML");
  }
  const YAML::Node table =
      all.IsMap() ? all["rosbag2_bagfile_information"] : YAML::Node(YAML::NodeType::Undefined);
  if (!table || !table.IsMap())
    refuse_metadata(path, 1, "has no table rosbag2_bagfile_information");
  BagMetadata data;
  data.version = value_of<long>(table, "version", path);
  data.storage = value_of<std::string>(table, "storage_identifier", path);
  data.compression = text_or_nothing(table, "compression_mode", path);
  for (char& c : data.compression)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  data.compressed_by = text_or_nothing(table, "compression_format", path);
  data.files = value_of<std::vector<std::string>>(table, "relative_file_paths", path);
  if (data.files.empty()) refuse_metadata(path, line_of(table), "names no file");
  return data;
}
#else
BagMetadata parse_bag_metadata(const std::string&, const std::string& path) {
  refuse_metadata(path, 0, "cannot be read: the program was built without libyaml-cpp-dev");
}
#endif

}  // namespace sinew

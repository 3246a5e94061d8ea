// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/bag_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "identification/logs/joint_states.h"
#include "symbolic/files/read_text.h"
#include "symbolic/files/readable.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

struct Storage {
  std::string_view name;
  void (*add)(const std::string& path, JointStateTopics& topics);
};
constexpr Storage kStorages[] = {{"sqlite3", &add_sqlite_states}, {"mcap", &add_mcap_states}};

const Storage* storage_of(std::string_view name) {
  const auto* found = std::find_if(std::begin(kStorages), std::end(kStorages),
                                   [&](const Storage& s) { return s.name == name; });
  return found == std::end(kStorages) ? nullptr : found;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& what) {
  throw std::runtime_error(fmt::format("{}:0:0: {}", readable_line(file.string()), what));
}

std::string text_of(const fs::path& metadata) {
  std::error_code error;
  if (!fs::exists(metadata, error))
    refuse(metadata.parent_path(),
           "is a folder without metadata.yaml; expected a log, or the folder of a recording of "
           "ROS 2: ros2 bag reindex writes its metadata.yaml");
  Findings findings;
  const std::string text = read_text(metadata, findings);
  if (findings.any()) refuse(metadata, "cannot be read; expected a text that rosbag2 wrote");
  return text;
}

void require_readable(const BagMetadata& data, const fs::path& metadata) {
  if (!storage_of(data.storage))
    refuse(metadata, fmt::format("the recording is kept in '{}', which is not read here; expected "
                                 "sqlite3 or mcap: write it anew with ros2 bag convert",
                                 readable_line(data.storage)));
  if (!data.compression.empty() && data.compression != "NONE")
    refuse(metadata, fmt::format("the recording is compressed by the {} ({}), which is not read "
                                 "here; write it anew without compression_mode, with ros2 bag "
                                 "convert",
                                 data.compression == "FILE" ? "file" : "message",
                                 readable_line(data.compressed_by)));
}

/// Until version 3 the paths begin with the folder's own name.
fs::path part_of(const fs::path& folder, const std::string& name, long version,
                 const fs::path& metadata) {
  constexpr long kWithoutFolder = 4;
  const fs::path named = fs::path(name).lexically_normal();
  const fs::path inside = version < kWithoutFolder ? named.filename() : named;
  if (inside.empty() || inside.is_absolute() || *inside.begin() == "..")
    refuse(metadata, fmt::format("names the part '{}', which is not in this folder; expected the "
                                 "parts beside metadata.yaml: ros2 bag reindex writes it anew",
                                 readable_line(name)));
  const fs::path part = folder / inside;
  std::error_code error;
  if (!fs::exists(part, error))
    refuse(part,
           "is missing, a part of the recording that metadata.yaml names; copy it here, or "
           "ros2 bag reindex writes metadata.yaml for the parts that are there");
  if (!fs::is_regular_file(part, error)) refuse(part, "is no file; expected a part of a recording");
  return part;
}

}  // namespace

BagFolder open_bag_folder(const std::string& folder) {
  BagFolder bag;
  bag.metadata = fs::path(folder) / "metadata.yaml";
  const BagMetadata data = parse_bag_metadata(text_of(bag.metadata), bag.metadata.string());
  require_readable(data, bag.metadata);
  bag.storage = data.storage;
  for (const std::string& name : data.files) {
    const std::string part = part_of(folder, name, data.version, bag.metadata).string();
    if (std::find(bag.parts.begin(), bag.parts.end(), part) != bag.parts.end())
      refuse(bag.metadata, fmt::format("names the part '{}' twice; expected each once: ros2 bag "
                                       "reindex writes it anew",
                                       readable_line(name)));
    bag.parts.push_back(part);
  }
  return bag;
}

std::vector<LogColumn> read_bag_folder(const std::string& folder) {
  const BagFolder bag = open_bag_folder(folder);
  JointStateTopics topics;
  for (const std::string& part : bag.parts) storage_of(bag.storage)->add(part, topics);
  return joint_state_columns(topics, folder);
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// The folder that rosbag2 makes of a recording: metadata.yaml, and the files of the recording that
// it names, in their order in time.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identification/logs/converted_log.h"

namespace sinew {

/// What metadata.yaml says that a reader has to know.
struct BagMetadata {
  long version = 0;
  std::string storage;             ///< storage_identifier: "sqlite3", "mcap", ...
  std::string compression;         ///< compression_mode in capitals: "", "NONE", "FILE", "MESSAGE"
  std::string compressed_by;       ///< compression_format
  std::vector<std::string> files;  ///< relative_file_paths, at least one
};

/// Reads the keys above and passes over all others. Throws std::runtime_error "file:line:0: ..."
/// where the text is no YAML, or one of them is missing or of another type, and where the program
/// was built without yaml-cpp.
BagMetadata parse_bag_metadata(const std::string& text, const std::string& path);

/// A recording's folder: what its parts are kept in, and metadata.yaml and the parts themselves.
struct BagFolder {
  std::string storage;
  std::filesystem::path metadata;
  std::vector<std::string> parts;  ///< paths, in their order in time
};

/// Throws std::runtime_error "file:line:0: ..." where the folder has no metadata.yaml, or a part is
/// missing, outside the folder, compressed, or kept in what is not read here.
BagFolder open_bag_folder(const std::string& folder);

/// The joint states of all parts as one log (joint_states.h). Throws as above, and where a part
/// cannot be read.
std::vector<LogColumn> read_bag_folder(const std::string& folder);

}  // namespace sinew

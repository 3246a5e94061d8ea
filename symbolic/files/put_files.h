// SPDX-License-Identifier: GPL-3.0-or-later
// Files of a folder replaced together or not at all.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace sinew {

/// Puts files (name -> content) into `folder`, which exists afterwards with all of them, or is left
/// as it was. Other files of the folder are kept. Parents are made as needed. Throws
/// std::runtime_error if the folder holds something and may not be replaced, or on a failed write.
void put_files(const std::filesystem::path& folder, const std::map<std::string, std::string>& files,
               bool may_replace);

}  // namespace sinew

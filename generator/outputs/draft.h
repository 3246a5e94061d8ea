// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts of outputs, and the ways back to what they replace, on the disk on return.
#pragma once

#include <filesystem>
#include <string>

#include "generator/outputs/outputs.h"

namespace sinew {

/// Open for writing, with the permissions of `target` where that exists. Throw std::runtime_error.
Descriptor new_draft(const std::filesystem::path& draft, const std::filesystem::path& target);
void write_draft_file(const std::filesystem::path& draft, const std::string& text,
                      const std::filesystem::path& target);
void write_draft_folder(const std::filesystem::path& draft, const FileSet& files);

/// A second name of the file, or a folder of second names, folders in it included; copies where
/// there can be none. Throws std::runtime_error.
void keep_way_back(const std::filesystem::path& target, const std::filesystem::path& old);

}  // namespace sinew

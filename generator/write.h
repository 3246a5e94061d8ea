// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/model.h"
#include "generator/outputs/outputs.h"

namespace sinew {

/// Names of the files of an emitted model, sorted; those below a folder with the folder.
std::vector<std::string> emitted_file_names(const EmittedModel& model);

/// Everything that `generate` writes, in memory.
FileSet emit_files(const EmittedModel& model);

/// Has `folder` hold just `files` when the outputs are committed. Throws std::runtime_error where
/// it holds files that no manifest of ours lists.
void add_emitted(Outputs& outputs, const std::filesystem::path& folder, const FileSet& files);

/// That alone and at once: `folder` is the old or the new one at every moment. On a file system
/// that cannot exchange two folders the old one may, after an interruption, stand beside its place
/// until the next run puts it back. Throws std::runtime_error also where writing fails; nothing has
/// changed then.
void replace_folder(const std::filesystem::path& folder, const FileSet& files);

/// Unified diff from what `folder` holds to `files`; empty where they are the same.
std::string difference(const std::filesystem::path& folder, const FileSet& files);

}  // namespace sinew

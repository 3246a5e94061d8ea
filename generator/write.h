// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "generator/model.h"

namespace sinew {

/// File name -> content, all files of one emitted model.
using FileSet = std::map<std::string, std::string>;

/// Names of the files of an emitted model, sorted.
std::vector<std::string> emitted_file_names(const EmittedModel& model);

/// Everything that `generate` writes, in memory.
FileSet emit_files(const EmittedModel& model);

/// Replaces `folder` by one that holds just `files`, in one step: an interruption at any moment
/// leaves the old folder whole. Left-overs of interrupted runs beside it are removed. On a file system
/// that cannot exchange two folders the old one may, after an interruption, stand beside its place
/// (.<name>.old-<process>) until the next run puts it back.
/// Throws std::runtime_error where `folder` holds files that no manifest of ours lists, or where
/// writing fails; nothing has changed then.
void replace_folder(const std::filesystem::path& folder, const FileSet& files);

/// Unified diff from what `folder` holds to `files`; empty where they are the same.
std::string difference(const std::filesystem::path& folder, const FileSet& files);

}  // namespace sinew

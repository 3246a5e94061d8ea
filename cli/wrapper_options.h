// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "generator/outputs/outputs.h"

namespace sinew {

/// Which wrappers `generate` and `check` are about: --python, --cpp and so on, and --wrappers.
struct WrapperOptions {
  std::map<std::string, bool> wanted;
  std::string folder = "wrappers", runtime;

  bool any() const;
  /// The options as they are written, those that are as by default left out: " --python".
  std::string written() const;
};

void add_wrapper_options(CLI::App& command, WrapperOptions& options);

/// Folder -> its files: <folder>/<model>/<wrapper>, of each wrapper that is wanted. `emitted`: the
/// model's files (emit_files). Throws std::runtime_error where the model cannot be wrapped so.
std::map<std::filesystem::path, FileSet> wrapped_files(const WrapperOptions& options,
                                                       const std::string& model,
                                                       const FileSet& emitted);

/// Unified diff from what stands in `folder` to `files`; what else is there does not count.
std::string wrapper_difference(const std::filesystem::path& folder, const FileSet& files);

}  // namespace sinew

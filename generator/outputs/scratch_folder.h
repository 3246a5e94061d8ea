// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of this process alone, gone in the end.
#pragma once

#include <filesystem>

#include "generator/outputs/interruption.h"

namespace sinew {

/// A new folder where temporary files belong (TMPDIR), removed with all below it by the destructor
/// or by an interruption. Throws std::runtime_error where none can be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  RemovedIfInterrupted folder_;
};

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// A program that writes a folder, under strace, which makes one of its system calls fail or its
// end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/generator/lettered_files.h"

namespace sinew {

/// All files below, by relative path.
FileSet files_in(const std::filesystem::path& folder);
std::size_t entries_in(const std::filesystem::path& folder);

/// False where strace is missing or may not trace.
bool strace_works();

/// False in a build with sanitizers, whose runtime repeats writes of its own until they succeed.
bool writes_may_fail();

struct Injected {
  bool happened = false;  ///< the program made as many calls
  int status = 0;
};

/// `<writer> <folder> n` under strace, which acts on the count-th of one kind of system call.
Injected inject(const std::string& call, const std::string& action, int count,
                const std::filesystem::path& folder, const std::vector<std::string>& more = {},
                const std::string& writer = SINEW_WRITE_FOLDER);

}  // namespace sinew

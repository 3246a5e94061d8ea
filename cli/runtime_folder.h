// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "generator/outputs/output_place.h"

namespace sinew {

/// Folder with the runtime's headers: `given` where it is not empty; else `runtime` below the
/// current folder, or what lies beside the program (in its build tree, or installed). Throws
/// std::runtime_error where none holds sinew_math.h.
std::filesystem::path runtime_folder(const std::string& given);

/// The headers in it.
void add_runtime(Inputs& inputs, const std::filesystem::path& runtime);

}  // namespace sinew

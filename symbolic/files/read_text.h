// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "symbolic/files/description_error.h"

namespace sinew {

/// The bytes of a file; "" and a finding without a line if it is none or cannot be read.
std::string read_text(const std::filesystem::path& path, Findings& findings);

}  // namespace sinew

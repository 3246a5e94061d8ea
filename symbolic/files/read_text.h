// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "symbolic/files/description_error.h"
#include "symbolic/files/limits.h"

namespace sinew {

/// The bytes of a file; "" and a finding without a line if it is none (a folder, a pipe, a device),
/// cannot be read, or holds more than `most_bytes`.
std::string read_text(const std::filesystem::path& path, Findings& findings,
                      std::uintmax_t most_bytes = limits::description_bytes);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// What a user is told where something was not foreseen.
#pragma once

#include <exception>
#include <string>

namespace sinew {

/// The program's own errors as they are. What comes out of a library (computer algebra, files,
/// JSON, TOML, memory, ...) is told as what it means, the library's words in brackets for a report
/// of the fault.
std::string clear_message(const std::exception& error);

}  // namespace sinew

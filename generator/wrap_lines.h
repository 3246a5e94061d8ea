// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sinew {

/// Emitted C with no line of more than 100 columns, where it has blanks to break at: never inside a
/// string, nor a line of the preprocessor. What is wrapped already stays as it is.
std::string wrap_lines(const std::string& text);

}  // namespace sinew

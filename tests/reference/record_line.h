// SPDX-License-Identifier: GPL-3.0-or-later
// What a test measured, kept where somebody asks for it.
#pragma once

#include <string>

namespace sinew::reference {

/// Appends the line to the file that SINEW_RECORD names; without it nothing is done. Throws
/// std::runtime_error if the file cannot be written.
void record_line(const std::string& json);

}  // namespace sinew::reference

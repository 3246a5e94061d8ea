// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sinew {

/// Unified diff with three lines of context; empty where the texts are equal.
std::string unified_diff(const std::string& before, const std::string& after,
                         const std::string& before_label, const std::string& after_label);

}  // namespace sinew

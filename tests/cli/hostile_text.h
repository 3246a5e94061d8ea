// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for everything the program says, whatever it was given.
#pragma once

#include <string>

#include "tests/cli/program.h"

namespace sinew {

/// The first byte that a terminal would act upon, a mark of direction or a byte that is no UTF-8,
/// as text; "" where there is none.
std::string first_raw(const std::string& output);

/// Runs `sinew <command>` in a shell, at most 20 s and 2 GB. It must end with 2, say `words` and
/// what was expected, and what it says must be short and have nothing raw.
void check_refused(const Workplace& here, const std::string& command, const std::string& words);

}  // namespace sinew

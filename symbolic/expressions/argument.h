// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments of a function to emit, with their symbols made.
#pragma once

#include <string>
#include <vector>

#include "generator/function.h"

namespace sinew {

/// A single number; its symbol is called `name`.
Argument scalar_argument(const std::string& name, const std::string& unit, const Range& range,
                         const std::string& doc);

/// `rows * cols` numbers, row-major, all in the same range; the symbols are called name_0, name_1,
/// …
Argument array_argument(const std::string& name, int rows, int cols, const std::string& unit,
                        const Range& range, const std::string& doc);

}  // namespace sinew

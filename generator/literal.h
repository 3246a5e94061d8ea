// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "generator/target.h"

namespace sinew {

/// The shortest C literal that reads back to the same bits, whatever the locale.
/// Throws std::range_error where the scalar type has no finite value for it.
std::string literal(double value, const Target& target);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sinew {

/// Where a value was read, for messages: file:line:column (line 0: unknown).
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
};

}  // namespace sinew

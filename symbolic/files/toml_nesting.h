// SPDX-License-Identifier: GPL-3.0-or-later
// How deep a TOML text is nested, told before a reader that recurses sees it.
#pragma once

#include <optional>
#include <string_view>

namespace sinew {

/// Line and column (characters, from 1) of the first place where a dotted key has more parts, or
/// brackets stand deeper inside one another, than `most`; nothing where there is none. What stands
/// in strings and comments does not count.
struct TextPlace {
  int line = 1;
  int column = 1;
};
std::optional<TextPlace> nested_deeper(std::string_view toml, int most);

}  // namespace sinew

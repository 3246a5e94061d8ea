// SPDX-License-Identifier: GPL-3.0-or-later
// How deep an XML text is nested, told before a reader that recurses sees it.
#pragma once

#include <string_view>

namespace sinew {

/// How many elements TinyXML finds inside one another, or more: never less, whatever the text.
int nesting_depth(std::string_view text);

}  // namespace sinew

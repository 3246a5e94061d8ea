// SPDX-License-Identifier: GPL-3.0-or-later
// Where a value comes from: the words a description may use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// text: printed in the source; assumed: a documented choice to be replaced; cad, measured,
/// identified, urdf: from there.
const std::vector<std::string>& origins();
bool is_origin(std::string_view word);
std::string origin_words();

}  // namespace sinew

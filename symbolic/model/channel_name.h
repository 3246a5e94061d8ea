// SPDX-License-Identifier: GPL-3.0-or-later
// How the columns of logs, simulated or measured, call a coordinate.
#pragma once

#include <algorithm>
#include <string>

namespace sinew {

/// "q_<joint>"; a name that is a q and a number itself, "q21" or "index.q21", stands as it is.
inline std::string position_channel(const std::string& joint) {
  const std::size_t own = joint.rfind('.') == std::string::npos ? 0 : joint.rfind('.') + 1;
  const bool numbered = joint.size() > own + 1 && joint[own] == 'q' &&
                        std::all_of(joint.begin() + static_cast<std::ptrdiff_t>(own) + 1,
                                    joint.end(), [](char c) { return c >= '0' && c <= '9'; });
  return numbered ? joint : "q_" + joint;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// How the columns of logs, simulated or measured, call a coordinate.
#pragma once

#include <algorithm>
#include <string>

namespace sinew {

/// "q_<joint>"; what is a q and a number itself, "q21", or a hand's coordinate, "index.q21", stands
/// as it is.
inline std::string position_channel(const std::string& joint) {
  const bool numbered =
      joint.size() > 1 && joint.front() == 'q' &&
      std::all_of(joint.begin() + 1, joint.end(), [](char c) { return c >= '0' && c <= '9'; });
  return numbered || joint.find('.') != std::string::npos ? joint : "q_" + joint;
}

}  // namespace sinew

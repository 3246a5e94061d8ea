// SPDX-License-Identifier: GPL-3.0-or-later
// The fingers of a hand as one mechanism, for logs of a hand whose palm is held.
#pragma once

#include <string>
#include <vector>

#include "symbolic/hand/hand.h"

namespace sinew {

struct HeldHand {
  /// All fingers on the palm {ABC}, the wrist in its reference pose, the four-bar in the middle of
  /// its range, gravity (0, 0, -9.81) m/s^2 in the forearm frame. Joints, bodies and tendons are
  /// called "<finger>_<name>".
  Mechanism mechanism;
  std::vector<std::string> coordinates;  ///< as coordinate_names calls them, without the crank
  std::vector<int> channels;             ///< wrist channel of each of its tendons, from 0
  Eigen::Matrix3d palm;                  ///< of {ABC} in the forearm frame
};

HeldHand held_hand(const Hand& hand);

}  // namespace sinew

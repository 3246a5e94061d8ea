// SPDX-License-Identifier: GPL-3.0-or-later
// An angle that a sensor wraps at a full turn, joined again.
#pragma once

#include <vector>

#include "identification/logs/channel_map.h"

namespace sinew {

/// Follows one angle [rad] through its jumps of a full turn.
class FullTurns {
 public:
  /// The value without its jumps. A jump is a full turn from where the motion leads, within 1 %.
  double push(long row, double value);

  /// The values stay within one turn, and nothing but the jumps is larger than a quarter of it.
  bool is_wrapped() const;
  long jumps() const { return jumps_; }
  long first_row() const { return first_row_; }
  /// Whole turns [rad] to add so that the middle of the motion is nearest to `middle`.
  double shift_towards(double middle) const;

 private:
  long count_ = 0, jumps_ = 0, first_row_ = 0;
  double previous_ = 0.0, step_ = 0.0, turns_ = 0.0;
  double raw_low_ = 0.0, raw_high_ = 0.0, low_ = 0.0, high_ = 0.0;
  double largest_step_ = 0.0;  ///< that is no jump
};

/// Which of the channels are wrapped: angles, and references whose position is wrapped too.
std::vector<bool> wrapped_channels(const std::vector<MappedColumn>& channels,
                                   const std::vector<FullTurns>& turns);

}  // namespace sinew

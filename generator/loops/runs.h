// SPDX-License-Identifier: GPL-3.0-or-later
// Repetitions in a sequence.
#pragma once

#include <cstdint>
#include <vector>

namespace sinew {

/// `count` times the same `period` keys from `start`, and the beginning of one time more: `length`
/// keys in all.
struct Repetition {
  int start = 0;
  int period = 0;
  int count = 0;
  int length = 0;
};

/// The longest run from each place on that is in no run before it; at least three times.
std::vector<Repetition> runs_of(const std::vector<std::uint64_t>& keys);

}  // namespace sinew

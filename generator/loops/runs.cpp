// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/loops/runs.h"

namespace sinew {
namespace {

constexpr int fewest_times = 3;
constexpr int longest_period = 32;

int length_of_run(const std::vector<std::uint64_t>& keys, int start, int period) {
  int length = period;
  const int size = static_cast<int>(keys.size());
  while (start + length < size && keys[static_cast<std::size_t>(start + length)] ==
                                      keys[static_cast<std::size_t>(start + length - period)])
    ++length;
  return length;
}

Repetition longest_run(const std::vector<std::uint64_t>& keys, int start) {
  Repetition best{start, 0, 0, 0};
  const int left = static_cast<int>(keys.size()) - start;
  for (int period = 1; period <= longest_period && fewest_times * period <= left; ++period) {
    const int length = length_of_run(keys, start, period);
    const int count = length / period;
    if (count >= fewest_times && count * period > best.count * best.period)
      best = {start, period, count, length};
  }
  return best;
}

}  // namespace

std::vector<Repetition> runs_of(const std::vector<std::uint64_t>& keys) {
  std::vector<Repetition> runs;
  for (int start = 0; start < static_cast<int>(keys.size());) {
    const Repetition run = longest_run(keys, start);
    if (run.count > 0) runs.push_back(run);
    start += run.count > 0 ? run.count * run.period : 1;
  }
  return runs;
}

}  // namespace sinew

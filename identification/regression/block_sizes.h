// SPDX-License-Identifier: GPL-3.0-or-later
// Products of large matrices are summed in the same order on every machine.
#pragma once

#include <Eigen/Core>

namespace sinew::diagnosis {

/// Eigen sums products in blocks that fit the processor's caches, so that their last digits are the
/// machine's; where two explanations are nearly alike a verdict hangs on them. From now on this
/// process uses blocks of one size. Call it once, before any thread multiplies.
inline void fix_block_sizes() {
  constexpr std::ptrdiff_t kibibyte = 1024;
  Eigen::setCpuCacheSizes(32 * kibibyte, 256 * kibibyte, 2048 * kibibyte);
}

}  // namespace sinew::diagnosis

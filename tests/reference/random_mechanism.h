// SPDX-License-Identifier: GPL-3.0-or-later
// Seeded random mechanisms: physical, well-conditioned, of the sizes fingers and arms have.
#pragma once

#include <cstdint>

#include "symbolic/model/mechanism.h"

namespace sinew::reference {

struct RandomMechanismOptions {
  int joints = 6;          ///< all joints, fixed ones included
  double prismatic = 0.2;  ///< share of sliding joints; 3 and more joints get at least one
  double fixed = 0.15;     ///< share of fixed joints; 3 and more joints get at least one
  bool branched = false;   ///< a tree instead of a serial chain
  bool arm = false;        ///< links of 0.3 m and kilograms instead of 0.04 m and grams
  int tendons = 0;         ///< tendons with constant radii over random joints
};

/// The same mechanism for the same seed and options. Its axes are a mixture of parallel,
/// perpendicular and arbitrary ones, its offsets of zero and nonzero ones; inertias are those of
/// solid boxes turned arbitrarily. The last body carries the frame "tip".
Mechanism random_mechanism(std::uint64_t seed, const RandomMechanismOptions& options);

}  // namespace sinew::reference

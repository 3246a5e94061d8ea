// SPDX-License-Identifier: GPL-3.0-or-later
// What functions compute alike: candidates for parts.
#pragma once

#include <cstddef>
#include <vector>

#include "generator/calls/part.h"
#include "generator/calls/places.h"

namespace sinew {

/// What other places have of the values at one place.
struct Alike {
  Place base;
  std::vector<double> gains;            ///< instructions that each value is written with
  std::vector<bool> inner;              ///< values that the place has, not those it is given
  std::vector<PartInstance> instances;  ///< the base among them

  /// Instructions of these values, or of those among them that an instance has.
  double weight(const std::vector<bool>& values, const PartInstance* instance = nullptr) const;
};

/// The values that one place has alike with another.
struct PartCandidate {
  std::size_t alike = 0;  ///< which of all Alikes
  std::vector<bool> may;
  double score = 0.0;  ///< instructions that would be written once instead of several times
};

/// Of every place of the functions. `least`: instructions alike, fewer are none.
std::vector<Alike> all_alike(const std::vector<CallingFunction>& functions, double least);

/// Those that promise most, best first.
std::vector<PartCandidate> part_candidates(const std::vector<Alike>& all);

}  // namespace sinew

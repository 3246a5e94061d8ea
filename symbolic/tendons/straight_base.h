// SPDX-License-Identifier: GPL-3.0-or-later
// A base of two joints held by straight tendons, as the thumb's (5.4), found in a mechanism.
#pragma once

#include <optional>
#include <vector>

#include "generator/function.h"
#include "symbolic/tendons/link_position.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

struct StraightBase {
  ThumbBaseParameters parameters;  ///< distal points in the second body's frame: length 0
  std::vector<std::size_t> base_tendons;
  std::vector<std::size_t> other_tendons;
};

/// The base, where the first coordinate turns about z of an unturned frame, the second about -y of
/// the first body's frame beside it, and two or more tendons consist of one straight stretch from
/// the base to the second body. Nothing otherwise.
std::optional<StraightBase> straight_base(const Mechanism& mechanism);

/// link_position, link_position_warm (one iteration, for a start a tick away),
/// link_position_gradient_step and link_position_covariance for the base, and hinge_position for
/// the other joints where their coupling is constant.
std::vector<Function> straight_base_functions(const Mechanism& mechanism, const StraightBase& base);

}  // namespace sinew

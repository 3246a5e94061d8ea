// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/extension/part_observation.h"

#include "symbolic/extension/lever_observation.h"
#include "symbolic/extension/wrist_observation.h"

namespace sinew {

std::optional<Observation> observation_of(const Part& part) {
  if (const auto* lever = std::get_if<LeverParameters>(&part.parameters))
    return lever_observation({*lever, 0.0}, part.name);
  if (const auto* tendon = std::get_if<TendonWithLever>(&part.parameters))
    return lever_observation(
        {tendon->lever, tendon->tendon.free_length / tendon->tendon.axial_stiffness}, part.name);
  if (const auto* wrist = std::get_if<WristParameters>(&part.parameters))
    return wrist_observation(*wrist, part.name);
  return std::nullopt;
}

}  // namespace sinew

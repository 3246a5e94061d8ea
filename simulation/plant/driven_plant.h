// SPDX-License-Identifier: GPL-3.0-or-later
// Joints whose motion follows from the emitted effort alone, under given efforts: what a log's
// efforts would have moved.
#pragma once

#include "simulation/plant/plant.h"

namespace sinew {

/// Commands of the scenario: tau_<name> and load_<name> (against the joint) of each coordinate of
/// the drives, motors among them, and tension_1, ... of their tendons. The drives include their
/// bodies. Fixed steps only: there are no energy books.
Plant driven_plant(const Drives& drives, const std::vector<std::string>& names,
                   const Scenario& scenario);

}  // namespace sinew

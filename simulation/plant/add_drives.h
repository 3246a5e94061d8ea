// SPDX-License-Identifier: GPL-3.0-or-later
// The drives of what is simulated: what its description says of them and what logs taught.
#pragma once

#include <filesystem>

#include "simulation/plant/plant.h"
#include "symbolic/hand/hand_mechanism.h"

namespace sinew {

/// Of a motor alone: none where nothing was learnt, unless the efforts are a log's.
void add_drives(const MotorParameters& motor, const std::string& name, const Identified& identified,
                const Scenario& scenario, const std::filesystem::path& runtime, PlantParts& parts);

/// Of the joints of a mechanism in the folder `model` and, where an entry speaks of them, of its
/// tendons' motors; none where its joints have neither friction nor armature and nothing was
/// learnt, unless the efforts are a log's.
void add_drives(const Mechanism& mechanism, const Identified& identified, const Scenario& scenario,
                const std::filesystem::path& model, const std::filesystem::path& runtime,
                PlantParts& parts);

/// Of the fingers of a hand, its crank and wrist apart; none as above.
void add_drives(const HeldHand& held, const Identified& identified, const Scenario& scenario,
                const std::filesystem::path& runtime, PlantParts& parts);

/// The hand with the payloads that logs taught.
Hand with_identified(Hand hand, const Identified& identified);

}  // namespace sinew

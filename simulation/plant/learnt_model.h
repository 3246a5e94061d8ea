// SPDX-License-Identifier: GPL-3.0-or-later
// The driven model that the entries of an identified.toml speak of.
#pragma once

#include <filesystem>
#include <optional>

#include "symbolic/extension/driven_model.h"
#include "symbolic/hand/hand.h"

namespace sinew {

/// Folder of the motor that is described beside a model: ../motor.
std::filesystem::path folder_of_motor(const std::filesystem::path& model);

/// That motor; nothing where there is none.
std::optional<MotorParameters> motor_beside(const std::filesystem::path& model);

/// It acts at a tendon's motor, or by that motor's motion.
bool needs_motors(const IdentifiedEffect& entry);

/// Some entry needs them.
bool speaks_of_motors(const Identified& identified);

/// Driven by its tendons where an entry speaks of tendons or of their motors, else at its joints.
/// `folder`: of the model, for the motor beside it.
DrivenModel learnt_model(const Mechanism& mechanism, const Identified& identified,
                         const std::filesystem::path& folder);

/// All fingers, the palm held.
DrivenModel learnt_model(const Hand& hand, const Identified& identified);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// identified.toml of a model that is driven, read at the places that the model has, and refused
// where what it says leaves a mass matrix that is not positive definite.
#pragma once

#include <filesystem>

#include "symbolic/extension/identified.h"
#include "symbolic/hand/hand.h"
#include "symbolic/model/mechanism.h"
#include "symbolic/parts/part.h"

namespace sinew {

/// Each is empty where the folder has no identified.toml, and throws DescriptionError with the
/// file's name and all mistakes found. `described`, `hand`, `motor`: the model without its
/// extension.
Identified checked_extension(const std::filesystem::path& folder, const Mechanism& described);
Identified checked_extension(const std::filesystem::path& folder, const Hand& hand);
Identified checked_extension(const std::filesystem::path& folder, const MotorParameters& motor);

}  // namespace sinew

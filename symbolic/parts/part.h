// SPDX-License-Identifier: GPL-3.0-or-later
// A part of a hand that is no chain of bodies: its closed form has its own parameters.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "generator/function.h"
#include "symbolic/parts/four_bar.h"
#include "symbolic/parts/guiding_friction.h"
#include "symbolic/parts/lever.h"
#include "symbolic/parts/motor.h"
#include "symbolic/parts/tendon_force.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

/// Friction of guides, fitted form (C0, C1) or capstan law (friction coefficient).
struct FittedGuiding {
  GuidingParameters parameters;
};
struct CapstanGuiding {
  GuidingParameters parameters;
};

/// A tendon in series with its lever.
struct TendonWithLever {
  TendonParameters tendon;
  LeverParameters lever;
};

/// The regressors of every effect that a diagnosis knows (symbolic/effects).
struct EffectLibrary {};

struct Part {
  std::string name;  ///< C identifier, prefix of emitted functions
  std::string description;
  std::variant<WristParameters, FourBarParameters, LeverParameters, MotorParameters, FittedGuiding,
               CapstanGuiding, TendonWithLever, EffectLibrary>
      parameters;
};

/// Whether a model folder describes a part (part.toml) and not a mechanism.
bool is_part_folder(const std::filesystem::path& folder);

/// Reads part.toml (docs/model_files.md). Throws DescriptionError with all mistakes found.
Part read_part(const std::filesystem::path& folder);

/// Every function the part offers.
std::vector<Function> functions_of(const Part& part);

}  // namespace sinew

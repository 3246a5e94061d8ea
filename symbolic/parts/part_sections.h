// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of part.toml, one a kind of part.
#pragma once

#include "symbolic/parts/part.h"
#include "symbolic/files/toml_reader.h"

namespace sinew {

WristParameters read_wrist(TomlTable& table, std::vector<TomlTable> tendons);
FourBarParameters read_four_bar(TomlTable& table);
LeverParameters read_lever(TomlTable& table);
MotorParameters read_motor(TomlTable& table, std::vector<TomlTable> ripples);
GuidingParameters read_fitted_guiding(TomlTable& table);
GuidingParameters read_capstan(TomlTable& table);
TendonParameters read_tendon(TomlTable& table);

}  // namespace sinew

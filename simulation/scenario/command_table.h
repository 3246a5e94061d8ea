// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "simulation/scenario/signal.h"
#include "symbolic/files/description_error.h"
#include "symbolic/files/units.h"

namespace sinew {

/// Commands sampled in a CSV file: a column `time [s]` and one `channel [unit]` column a channel.
/// Mistakes go to `findings`: a missing or wrong
/// unit, an unknown column, a cell that is no finite number, a row too long or too short, time that
/// does not rise; nothing is returned for the table then.
std::map<std::string, SampledSignal> read_command_table(
    const std::filesystem::path& file, const std::map<std::string, Dimension>& channels,
    Findings& findings);

}  // namespace sinew

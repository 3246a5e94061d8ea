// SPDX-License-Identifier: GPL-3.0-or-later
// Logs as files, as a recorder writes them, and what goes wrong with recorders.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/blind/truth/trial_plant.h"

namespace sinew::trials {

/// CSV, nine digits. `own_names`: columns are called as the recorder calls them, not as the
/// channels.
void write_log(const Log& log, bool own_names, const std::filesystem::path& file);

/// channels.toml for those names.
void write_channel_names(const Log& log, const std::filesystem::path& file);

/// What `sinew diagnose` proposes to play: <position>_ref columns, then the load where there is
/// one.
struct PlannedMotion {
  double step = 0.0;   ///< s
  MatrixXd reference;  ///< rows x axes
  VectorXd load;       ///< empty: none
};
/// Throws std::invalid_argument with file and row where it is none.
PlannedMotion read_motion(const std::filesystem::path& file);

/// A fault of the data: a unit slip of one channel or of the clock, a current for a torque, a sign,
/// two channels exchanged. Returns what was done: {"fault", "channel", "factor"}.
nlohmann::json spoil_log(Log& log, truth::Draw& draw);

}  // namespace sinew::trials

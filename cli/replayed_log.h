// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "identification/adoption/prediction.h"
#include "identification/adoption/replay.h"

namespace sinew {

struct ReplayedLog {
  diagnosis::DrivenChannels channels;
  diagnosis::Replay replay;
  std::vector<std::string> notes;  ///< what is to be said of it
};

/// A log of a model read as `sinew diagnose` reads it. `map`: texts of --map, which go before the
/// folder's channels.toml. Throws LogError, std::runtime_error.
ReplayedLog replayed_log(const std::filesystem::path& model, const std::string& log,
                         const std::vector<std::string>& map);

}  // namespace sinew

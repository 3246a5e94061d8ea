// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "identification/adoption/diagnose_observed.h"
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

/// What the model of a lever, a tendon or a wrist says of its sensors in a log; nothing for any
/// other model. `runtime`: folder of the runtime's headers. Throws as above.
std::optional<diagnosis::ObservedReplay> replayed_rig(const std::filesystem::path& model,
                                                      const std::string& log,
                                                      const std::vector<std::string>& map,
                                                      const std::filesystem::path& runtime);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "identification/logs/read_csv.h"

namespace sinew {

/// Logs of an experiment. An experiment can be repeated, so that what docs/logs.md repairs in a log
/// of work (cells that are no numbers, rows out of time) is refused here unless `repair` is set.
/// A velocity that is not the derivative of its position is refused too: one of both columns is
/// another one. Throws LogError naming file, row and column.
std::vector<Log> read_experiment_logs(const std::vector<std::string>& files,
                                      const std::vector<std::string>& map,
                                      const std::vector<ChannelSpec>& channels, bool repair);

}  // namespace sinew

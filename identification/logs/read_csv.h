// SPDX-License-Identifier: GPL-3.0-or-later
// Reading a log from CSV text as any tool writes it.
#pragma once

#include <string>
#include <vector>

#include "identification/logs/channel_map.h"
#include "identification/logs/log.h"

namespace sinew {

struct ReadOptions {
  std::vector<std::string> map;  ///< texts of --map, see map_columns
  long max_samples = 200000;     ///< kept a channel; a longer log is low-passed and thinned out
  double max_rate = 1e9;         ///< Hz; a faster log is thinned out, too, down to here or above
  /// Kept of all channels together: of a longer log Stretches are read at its own rate, which no
  /// thinning then lowers for max_samples' sake. 0: whole logs.
  long max_values = 0;
  int longest_fill = 5;           ///< missing samples in a row that interpolation may fill
  bool check_consistency = true;  ///< compare channels with one another and with the model
};

/// Reads the channels of `specs`. Comma, semicolon or tab between cells; one header row of
/// `name [unit]` cells, after comment lines with '#'; quoted cells, byte order mark, CR LF and
/// decimal commas (not with commas between cells) are understood. What is wrong with the log and
/// what was done about it is in Log::faults. Memory does not grow with the file beyond the samples
/// that are kept. Throws LogError where going on is not safe, std::runtime_error where the file is
/// no CSV text; both name file, row and column.
Log read_csv(const std::string& path, const std::vector<ChannelSpec>& specs,
             const ReadOptions& options = {});

struct LogFile {
  std::string path;
  std::vector<ChannelSpec> specs;
};

/// Several logs at a time, in the order given. Of several that cannot be used, the first one's
/// error is thrown.
std::vector<Log> read_csv(const std::vector<LogFile>& files, const ReadOptions& options);

}  // namespace sinew

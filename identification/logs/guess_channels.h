// SPDX-License-Identifier: GPL-3.0-or-later
// Which column of a log may be which channel, by what recorders call things: to be confirmed by a
// person, never used by itself.
#pragma once

#include <string>
#include <vector>

#include "identification/logs/channel_map.h"

namespace sinew {

/// What is known of a channel's column.
enum class GuessKind {
  understood,  ///< the reader finds it by itself
  guessed,     ///< name and unit speak for the column, and for no other one as much
  unit_less,   ///< the same, but the header names no unit: `unit` is the channel's own
  ambiguous,   ///< several columns as good
  none
};

struct ChannelGuess {
  std::string channel, unit;
  bool required = false;
  GuessKind kind = GuessKind::none;
  std::vector<std::string> columns{};  ///< one; several where ambiguous
};

/// For the time and each channel of `specs`, in their order. `joints`: names in the model's order,
/// for columns that are numbered. A column is guessed for one channel at most.
std::vector<ChannelGuess> guess_channels(const std::vector<std::string>& header,
                                         const std::vector<ChannelSpec>& specs,
                                         const std::vector<std::string>& joints);

/// channels.toml for a person to confirm: what is understood and what is not certain as comments.
std::string guessed_channels_toml(const std::vector<ChannelGuess>& guesses, const std::string& log);

}  // namespace sinew

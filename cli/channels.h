// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew channels <model folder> --log run.csv --out FILE`: a channels.toml to be confirmed,
/// guessed from the log's header; 1 where a channel that is needed has no line in it.
void add_channels_command(CLI::App& app, int& exit_status);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew parameters`: the constants of a hand's real-time step as C.
void add_parameters_command(CLI::App& app, int& exit_status);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew simulate <model> --scenario FILE --out FILE`.
void add_simulate_command(CLI::App& app, int& exit_status);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew identify <model> --experiment friction|inertia|ripple|lever|guiding --log FILE... --out
/// FILE`: chapter 3's experiments, the lever's calibration and guiding friction. Exit code 1 where
/// the logs cannot say.
void add_identify_command(CLI::App& app, int& exit_status);

}  // namespace sinew

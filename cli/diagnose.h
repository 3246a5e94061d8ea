// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew diagnose MODEL --log FILE… [--holdout FILE…] --out DIR [--map …] [--dry-run] [--json]`:
/// what the model gets wrong, its cause, the extended model and the gain.
void add_diagnose_command(CLI::App& app, int& exit_status);

}  // namespace sinew

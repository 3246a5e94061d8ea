// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew cost <model folder> [--passes | --methods | --reduced]`: operations per function, what
/// each pass brings, inverse dynamics by every method of derivation, or what a reduced model saves
/// and gets wrong.
void add_cost_command(CLI::App& app, int& exit_status);

/// `sinew dump <model folder> --function NAME [--after PASS] [--dot]`: any intermediate form.
void add_dump_command(CLI::App& app, int& exit_status);

}  // namespace sinew

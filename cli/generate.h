// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew generate <model folder> [--out DIR] [--scalar double|float]`.
void add_generate_command(CLI::App& app, int& exit_status);

/// `sinew check <model folder>`: regenerates and compares; 1 where the committed C differs.
void add_check_command(CLI::App& app, int& exit_status);

}  // namespace sinew

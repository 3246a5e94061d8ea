// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew figures [--out DIR] [--chapter N...] [--models DIR] [--generated DIR] [--runtime DIR]`:
/// the source's figures from the emitted C, as SVG and CSV, and on one page, index.html.
void add_figures_command(CLI::App& app, int& exit_status);

}  // namespace sinew

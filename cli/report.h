// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew report <model> [--out FILE] [--generated DIR] [--boards FILE]`: a model on one HTML page.
void add_report_command(CLI::App& app, int& exit_status);

}  // namespace sinew

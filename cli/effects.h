// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew effects`: the manual's page of the effects that a diagnosis knows, as Markdown.
void add_effects_command(CLI::App& app, int& exit_status);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace sinew {

/// `sinew import robot.urdf --out models/<name>`: a model folder from a URDF file. Sets exit_status
/// to 2 where the file or the folder cannot be used.
void add_import_command(CLI::App& app, int& exit_status);

}  // namespace sinew

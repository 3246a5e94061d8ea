// SPDX-License-Identifier: GPL-3.0-or-later
// The manual page and the shells' completions, both made from the commands' own options, so that
// they say what the program does.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sinew {

/// sinew(1) in roff (the macros of man(7)).
std::string manual_page(const CLI::App& app);

/// For bash: commands, then a command's options, then files.
std::string bash_completion(const CLI::App& app);

/// For zsh, with each option's description.
std::string zsh_completion(const CLI::App& app);

/// `sinew manual [--bash | --zsh]`: prints one of these.
void add_manual_command(CLI::App& app, int& exit_status);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// How the program tells what went wrong: to people on standard error, with --json to machines.
#pragma once

#include <string>
#include <string_view>

namespace sinew {

/// Whether --json is among the arguments (before "--").
bool wants_json(int argc, const char* const* argv);

/// On standard output {"errors": [{"message", "file", "line", "column"}, ...], "exit_status": 2};
/// an error for each line of `text`, with its place where the line begins with one
/// ("file:line:column: ...") and null where it does not.
void tell_errors(std::string_view text);

/// What the misspelt option in a message may have been, by the options in the text of --help:
/// " (did you mean '--scalar'?)", or "".
std::string meant_option(const std::string& message, const std::string& options);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// All that the program says: the one place where text reaches the standard streams. What names,
// cells and paths from outside would do to a terminal is escaped here (symbolic/files/readable.h).
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace sinew {

/// Text made readable on a stream. Whether it arrived is told by std::ferror at the end.
void put_readable(std::FILE* stream, std::string_view text);

/// From now on what tell() and print_to() say is dropped: only warnings, errors and JSON are left.
void be_quiet();
bool is_quiet();

/// On a stream, see stream_of_report().
template <typename... Args>
void print_to(std::FILE* stream, fmt::format_string<Args...> text, Args&&... args) {
  if (!is_quiet()) put_readable(stream, fmt::format(text, std::forward<Args>(args)...));
}

/// On standard output.
template <typename... Args>
void tell(fmt::format_string<Args...> text, Args&&... args) {
  if (!is_quiet()) put_readable(stdout, fmt::format(text, std::forward<Args>(args)...));
}

/// On standard error.
template <typename... Args>
void warn(fmt::format_string<Args...> text, Args&&... args) {
  put_readable(stderr, fmt::format(text, std::forward<Args>(args)...));
}

/// "sinew: <what>" on standard error, in lines of readable length; also where memory is out.
void complain(std::string_view what) noexcept;

/// JSON for machines on standard output: valid UTF-8 whatever bytes names and paths have.
void tell_json(const nlohmann::ordered_json& json);

/// The same as text, for a file.
std::string json_text(const nlohmann::ordered_json& json);

/// Writes over the line of a terminal where progress is shown; "" clears it. Nothing where standard
/// error is no terminal.
void show_progress(std::string_view text);

}  // namespace sinew

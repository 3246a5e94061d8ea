// SPDX-License-Identifier: GPL-3.0-or-later
// Text from outside made fit to be shown: in messages, on a terminal, in comments.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// The text with everything escaped that a terminal would act upon or that would show it in another
/// order: control characters but newline and tab (C0, DEL, C1), marks of direction and line
/// separators as \u001b, bytes that are no UTF-8 as \xff. Text of readable characters stays as it
/// is, and JSON stays JSON of the same meaning.
std::string readable(std::string_view text);

/// The same in one line: newlines and tabs are escaped, too, as \n and \t.
std::string readable_line(std::string_view text);

/// The text if it has at most `longest` characters (UTF-8 bytes); else its beginning and end, and
/// between them how much was left out.
std::string shortened(std::string_view text, std::size_t longest);

/// A part of a message: in one line and of readable length (limits::shown_characters).
std::string message_part(std::string_view text);

/// A message of several lines, each of readable length (limits::shown_line), all escaped.
std::string message_lines(std::string_view text);

/// "a, b, c"; of many names the first limits::shown_names and the number of the others.
std::string listed(const std::vector<std::string>& names);

}  // namespace sinew

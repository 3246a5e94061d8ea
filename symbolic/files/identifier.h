// SPDX-License-Identifier: GPL-3.0-or-later
// Names that end up in emitted C: checked, made, and suggested for a misspelling.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// Why a name cannot be used as a C and C++ identifier, or nothing if it can: letters, digits and
/// single underscores, starting with a letter, at most 63 characters, no keyword.
std::optional<std::string> why_not_identifier(std::string_view name);

/// What why_not_identifier wants, for messages.
std::string_view identifier_rule();

/// The nearest identifier to any text: "my-robot 2" gives "my_robot_2".
std::string make_identifier(std::string_view text);

/// The candidate nearest to a misspelt name (at most a third of its letters wrong), or "".
std::string nearest(std::string_view name, const std::vector<std::string>& candidates);

/// " (did you mean 'axis'?)", or "" where nothing is near.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace sinew

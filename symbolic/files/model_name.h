// SPDX-License-Identifier: GPL-3.0-or-later
// Names of models: prefixes of emitted functions and names of emitted files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sinew {

/// Why a model cannot be called so, or nothing if it can: an identifier (why_not_identifier) whose
/// files hide no other. A model `string` would emit string.h, which stands before the standard
/// library's wherever the model's folder is searched first.
std::optional<std::string> why_not_model_name(std::string_view name);

/// What why_not_model_name wants, for messages: a name like the one refused that would do.
std::string model_name_rule(std::string_view name);

/// The nearest such name to any text: "my-robot 2" gives "my_robot_2", "string" "string_model".
std::string make_model_name(std::string_view text);

}  // namespace sinew

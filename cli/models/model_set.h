// SPDX-License-Identifier: GPL-3.0-or-later
// Which model folders a command is about, and which models are made of others.
#pragma once

#include <filesystem>
#include <vector>

namespace sinew {

/// `given` itself, or, where it describes no model, the model folders in it, parts before the hands
/// that are made of them. `given` alone where there are none: reading it tells what is missing.
std::vector<std::filesystem::path> model_folders(const std::filesystem::path& given);

/// Hands beside `folder` that are made of it, by paths in the same style. A hand that cannot be
/// read counts as made of nothing.
std::vector<std::filesystem::path> hands_made_of(const std::filesystem::path& folder);

/// Model folders that `folder` is made of; empty unless it is a hand that can be read.
std::vector<std::filesystem::path> parts_of(const std::filesystem::path& folder);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// What a recorder calls the channels of a model: channels.toml beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sinew {

/// Texts as --map takes them ("channel=column name [unit]"), a line each of [channels] in the
/// folder's channels.toml, and `given`, which go before it for the same channel. Without that file
/// `given` alone. Throws DescriptionError with every mistake located.
std::vector<std::string> mapped_channels(const std::filesystem::path& model_folder,
                                         const std::vector<std::string>& given);

}  // namespace sinew

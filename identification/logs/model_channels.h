// SPDX-License-Identifier: GPL-3.0-or-later
// What a recorder calls the channels of a model: channels.toml beside it.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sinew {

/// Texts as --map takes them ("channel=column name [unit]"), a line each of [channels] in the
/// folder's channels.toml, and `given`, which go before it for the same channel. Without that file
/// `given` alone. Throws DescriptionError with every mistake located.
std::vector<std::string> mapped_channels(const std::filesystem::path& model_folder,
                                         const std::vector<std::string>& given);

/// By joint (or effort channel), the effort of 1 A at the joint [N*m/A, N/A]: of
/// [torque_constants] in the folder's channels.toml, and of `given`, texts "joint=VALUE" as
/// --torque-constant takes them, which go before it. Throws DescriptionError with every mistake of
/// the file located, std::invalid_argument for one of `given`.
std::map<std::string, double> torque_constants(const std::filesystem::path& model_folder,
                                               const std::vector<std::string>& given);

}  // namespace sinew

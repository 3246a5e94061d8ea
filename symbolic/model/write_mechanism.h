// SPDX-License-Identifier: GPL-3.0-or-later
// A Mechanism as a model folder that reads back identically.
#pragma once

#include <filesystem>
#include <string>

#include "symbolic/model/mechanism.h"

namespace sinew {

/// The texts of mechanism.toml and mass_properties.csv. Numbers are the shortest that read back as
/// the same double; rotations are given as roll, pitch, yaw where these reproduce the matrix
/// exactly, else as the matrix. `comment` becomes the first line of both.
struct ModelText {
  std::string toml;
  std::string csv;
};
ModelText describe_mechanism(const Mechanism& mechanism, const std::string& comment);

/// What to do with a folder that holds something.
enum class Existing { refuse, replace };

/// Writes the folder as a whole or not at all: the files are written to a folder beside it, which
/// then takes its place. With Existing::replace other files in the folder are kept. Throws
/// DescriptionError if the mechanism does not read back identically, std::runtime_error if the
/// folder holds something and is not to be replaced, or cannot be written.
void write_mechanism(const Mechanism& mechanism, const std::filesystem::path& folder,
                     const std::string& comment, Existing existing = Existing::refuse);

}  // namespace sinew

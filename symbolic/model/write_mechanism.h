// SPDX-License-Identifier: GPL-3.0-or-later
// A Mechanism as a model folder that reads back identically.
#pragma once

#include <map>
#include <string>

#include "symbolic/model/mechanism.h"

namespace sinew {

/// The texts of mechanism.toml, mass_properties.csv and names.toml ("" where every name is the
/// source's own). Numbers are the shortest that read back as
/// the same double; rotations are given as roll, pitch, yaw where these reproduce the matrix
/// exactly, else as the matrix. `comment` becomes the first line of each.
struct ModelText {
  std::string toml;
  std::string csv;
  std::string names;
};
ModelText describe_mechanism(const Mechanism& mechanism, const std::string& comment);

/// The files of its model folder, name -> content. Throws DescriptionError if the mechanism cannot
/// be described, std::runtime_error if it does not read back identically.
std::map<std::string, std::string> mechanism_files(const Mechanism& mechanism,
                                                   const std::string& comment);

}  // namespace sinew

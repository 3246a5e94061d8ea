// SPDX-License-Identifier: GPL-3.0-or-later
// A model folder as a Mechanism.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symbolic/files/description_error.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// Reads mechanism.toml, mass_properties.csv and, where it is there, names.toml of a folder
/// (docs/model_files.md). Values are
/// converted to SI, bodies sorted depth-first from the base with siblings in file order, axes made
/// unit vectors, quarter turns exact. Throws DescriptionError with all mistakes found.
Mechanism read_mechanism(const std::filesystem::path& model_folder);

/// The texts of the files, and what to call them in messages.
struct MechanismText {
  std::string_view toml;
  std::string_view csv;
  std::string toml_name = "mechanism.toml";
  std::string csv_name = "mass_properties.csv";
  std::string_view names = "";  ///< of names.toml (source_names.h); "" where there is none
  std::string names_name = "names.toml";
};

/// The same from text.
Mechanism parse_mechanism(const MechanismText& text);

}  // namespace sinew

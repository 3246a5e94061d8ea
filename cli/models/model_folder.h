// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <variant>

#include "generator/assemble.h"
#include "generator/outputs/outputs.h"
#include "symbolic/extension/identified.h"
#include "symbolic/hand/hand.h"
#include "symbolic/model/mechanism.h"
#include "symbolic/parts/part.h"

namespace sinew {

/// A model folder, read: what generate, check, cost and dump start from.
struct ModelFolder {
  std::variant<Mechanism, Part, Hand> model;
  ModelIdentity identity;
  std::filesystem::path folder;
  Identified identified;               ///< what logs taught; empty without identified.toml
  std::vector<std::string> remarks{};  ///< what a user has to know of what is derived
};

/// Puts right what an interrupted run left in the folder of a model and of those it is made of.
void recover_model(const std::filesystem::path& folder);

/// The files that describe the model and those it is made of.
void add_model(Inputs& inputs, const std::filesystem::path& folder);

/// Reads and checks a model folder. Throws DescriptionError with every mistake found,
/// std::runtime_error where a file cannot be read or an interrupted run's outputs not be put back.
ModelFolder open_model_folder(const std::filesystem::path& folder);

/// All functions of the folder's model, derived in their cheapest forms.
/// `runtime_parameters`: masses and gravity stay arguments of a mechanism's dynamics.
std::vector<Function> derive_functions(const ModelFolder& folder, bool runtime_parameters = false);

/// Where `generate` writes by default: generated/<model> below the current folder.
std::filesystem::path default_output(const ModelFolder& folder);

/// `scalar`: "double" or "float"; `optimise`: "speed" or "size". Throws std::invalid_argument
/// otherwise.
Target target_named(const std::string& scalar, bool fused, const std::string& optimise);

}  // namespace sinew

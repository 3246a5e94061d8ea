// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "generator/target.h"

namespace sinew {

/// What a command line says of the processor that the C is meant for.
struct TargetOptions {
  std::string scalar = "double", optimise = "speed";
  bool fma = false;

  /// Throws std::invalid_argument where a word is none of those expected.
  Target target() const;
  /// The options as they are written, those that are as by default left out: " --fma".
  std::string written() const;
};

/// --scalar, --fma and --optimise.
void add_target_options(CLI::App& command, TargetOptions& options);

}  // namespace sinew

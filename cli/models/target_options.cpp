// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/models/target_options.h"

#include "cli/models/model_folder.h"

namespace sinew {

Target TargetOptions::target() const {
  return target_named(scalar, fma, optimise);
}

std::string TargetOptions::written() const {
  std::string text;
  if (scalar != "double") text += " --scalar " + scalar;
  if (fma) text += " --fma";
  if (optimise != "speed") text += " --optimise " + optimise;
  return text;
}

void add_target_options(CLI::App& command, TargetOptions& options) {
  command.add_option("--scalar", options.scalar, "double or float");
  command.add_flag("--fma", options.fma,
                   "For processors with fused multiply-add, and only for them");
  command.add_option("--optimise", options.optimise, "speed or size (default: speed)");
}

}  // namespace sinew

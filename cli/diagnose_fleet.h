// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnosis of many logs by their sums: `sinew diagnose --summarise` and `--sums`.
#pragma once

#include <string>
#include <vector>

#include "generator/outputs/outputs.h"
#include "identification/adoption/diagnose.h"

namespace sinew {

/// Writes the sums of the log in `request.holdout` to `out`. Returns the exit code.
int run_summarise(const diagnosis::DiagnoseRequest& request, const std::string& out,
                  const Inputs& inputs, bool json);

/// Adds up files of sums and tells what they say. Returns the exit code.
int run_sums(const diagnosis::DiagnoseRequest& request, const std::vector<std::string>& training,
             const std::vector<std::string>& held_out, bool json);

}  // namespace sinew

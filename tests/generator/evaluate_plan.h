// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a plan pass by pass: what the loops say, without C.
#pragma once

#include <vector>

#include "generator/loops/plan.h"

namespace sinew {

/// All results, one output after the other, in double.
std::vector<double> evaluate_plan(const Graph& graph, const Plan& plan,
                                  const std::vector<double>& inputs);

}  // namespace sinew

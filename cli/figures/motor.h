// SPDX-License-Identifier: GPL-3.0-or-later
// Chapter 3's figures from simulated experiments.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/figures/figure.h"
#include "simulation/emitted/compiled_model.h"

namespace sinew {

/// Fig. 3.3 (velocities and friction curve), 3.4 (repeated runs), 3.5 (two velocities), 3.6 (before
/// and after compensation), from the scenarios of the motor's model folder. `emitted`: its C.
/// `runtime`: the runtime's headers. Throws what build_plant throws.
std::vector<Figure> figures_motor(const std::filesystem::path& model, const CompiledModel& emitted,
                                  const std::filesystem::path& runtime);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Chapter 4's figures of the variable-stiffness lever.
#pragma once

#include <vector>

#include "cli/figures/figure.h"
#include "simulation/emitted/compiled_model.h"
#include "symbolic/parts/part.h"

namespace sinew {

/// Fig. 4.7: path length, force and stiffness of the lever's model.
Figure figure_lever(const CompiledModel& lever, const LeverParameters& parameters);

/// Fig. 4.8: a simulated calibration on the rig, with the polynomials fitted to it.
Figure figure_lever_calibration(const CompiledModel& lever, const TendonWithLever& parameters);

}  // namespace sinew

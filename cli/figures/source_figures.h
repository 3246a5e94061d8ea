// SPDX-License-Identifier: GPL-3.0-or-later
// The source's figures, computed by the emitted C.
#pragma once

#include "simulation/emitted/compiled_model.h"
#include "cli/figures/figure.h"
#include "symbolic/parts/wrist.h"

namespace sinew {

/// Fig. 5.7: a released finger with and without Coriolis terms and gravity.
Figure figure_coriolis(const CompiledModel& index);

/// Fig. 5.16 and the nine panels of Fig. 5.17: positions of the thumb's base by gradient search,
/// with Levenberg-Marquardt beside.
std::vector<Figure> figures_link_position(const CompiledModel& thumb);

/// Fig. 6.9, 6.10 and 6.12: constraint errors and tendon displacements of a moving wrist.
std::vector<Figure> figures_wrist(const CompiledModel& wrist, const WristParameters& parameters);

}  // namespace sinew

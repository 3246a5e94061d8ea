// SPDX-License-Identifier: GPL-3.0-or-later
// The lever's tendon path and spring at an angle, for the functions of lever.h and tendon_force.h.
#pragma once

#include "symbolic/expressions/definition_list.h"
#include "symbolic/parts/lever.h"

namespace sinew {

struct LeverGeometry {
  GiNaC::ex length;        ///< dL [m], up to a constant
  GiNaC::ex slope;         ///< d(dL)/dtheta [m/rad], by the virtual displacement of the pulley
  GiNaC::ex safe_slope;    ///< the same, kept away from 0 for divisions
  GiNaC::ex energy_slope;  ///< dU/dtheta [N·m/rad]
  GiNaC::ex preload_slope;  ///< of energy_slope by a shorter free length of the spring [N/rad]
  GiNaC::ex path_margin;   ///< smaller of both |D|² - k² [m²]: negative where pulleys overlap
};

LeverGeometry lever_geometry(DefinitionList& list, const LeverParameters& parameters,
                             const GiNaC::ex& theta);

/// dL at the free angle [m], to 60 digits.
GiNaC::numeric free_path_length(const LeverParameters& parameters);

/// Force -U'/dL' [N].
GiNaC::ex lever_force(DefinitionList& list, const LeverGeometry& geometry);

/// Limits an angle to the lever's travel, whichever way that runs.
GiNaC::ex within_travel(const LeverParameters& parameters, const GiNaC::ex& theta);

/// Limits an elongation to a metre either way, so that what is left of it stays finite.
GiNaC::ex limited_elongation(DefinitionList& list, const GiNaC::ex& elongation);

}  // namespace sinew

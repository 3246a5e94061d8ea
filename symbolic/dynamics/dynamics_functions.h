// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/function.h"
#include "symbolic/dynamics/choose_plan.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// mass_matrix, coriolis_matrix, gravity, bias, mass_matrix_and_bias, inverse_dynamics and
/// forward_dynamics, each in the form that is cheapest for itself; none where no body has a mass
/// (is_massless). Where the mass matrix is
/// singular everywhere there is no forward_dynamics (note_of_singular_mass_matrix). With
/// `runtime_parameters` masses and gravity are an argument (runtime_parameters.h) and
/// base_parameters comes first.
std::vector<Function> dynamics_functions(const Mechanism& mechanism, const CostOf& cost,
                                         bool runtime_parameters = false);

/// inverse_dynamics alone, the same as above. Throws std::invalid_argument where no body has a
/// mass.
Function inverse_dynamics_function(const Mechanism& mechanism, const CostOf& cost = {},
                                   bool runtime_parameters = false);

}  // namespace sinew

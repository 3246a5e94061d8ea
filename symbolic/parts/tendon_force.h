// SPDX-License-Identifier: GPL-3.0-or-later
// One tendon between motor and finger: the lever and the tendon's own elasticity in series, and no
// force when slack (4.1, 5.1).
#pragma once

#include <vector>

#include "symbolic/parts/lever.h"

namespace sinew {

struct TendonParameters {
  double axial_stiffness = 0.0;  ///< E S [N]
  double free_length = 0.0;      ///< l0 [m]
};

// Model `tendon`; all throw std::invalid_argument unless E S and l0 are positive.

/// series_stiffness(k_lever -> k): 1/k = 1/k_lever + l0/(E S) [N/m]; 0 for a lever without
/// stiffness.
Function tendon_series_stiffness(const TendonParameters& parameters);

/// force(elongation, theta -> out 3, residual 1): from the elongation of lever and tendon together
/// [m], force [N], stiffness [N/m] and lever angle [rad], by Newton's method from the angle
/// `theta`; residual [m]. Where the elongation is not above 0 the tendon is slack: force and
/// stiffness are 0.
Function tendon_force(const TendonParameters& parameters, const LeverParameters& lever);

/// All of the above.
std::vector<Function> tendon_force_functions(const TendonParameters& parameters,
                                             const LeverParameters& lever);

}  // namespace sinew

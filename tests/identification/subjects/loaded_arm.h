// SPDX-License-Identifier: GPL-3.0-or-later
// The arm of five joints with a load in its hand.
#pragma once

#include <Eigen/Core>

#include "symbolic/model/mechanism.h"

namespace sinew::test {

inline constexpr double kLoad = 0.6;  // kg
inline const Eigen::Vector3d kLoadCentre(0.05, -0.02, 0.03);

/// The arm with a point mass in its hand.
Mechanism loaded(Mechanism arm, double load = kLoad);

}  // namespace sinew::test

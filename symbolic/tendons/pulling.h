// SPDX-License-Identifier: GPL-3.0-or-later
// What tendons, which can only pull, can do to joints: the plausibility of a mechanism's routing.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "symbolic/model/plausibility.h"

namespace sinew {

/// Nothing where some tensions f > 0 leave the joints in balance, P^T f = 0. Else the motion v
/// (n, of largest entry 1) that shows there are none: it lengthens no tendon by less than zero and
/// one by more (P v >= 0), so that the tendons pull against it and nothing pulls back. `P` m x n.
std::optional<Eigen::VectorXd> motion_against_all(const Eigen::MatrixXd& P);

/// Joints that no tendon reaches, a rank of P = dh/dq below the number of coordinates, and tendons
/// without antagonists (no force closure), at the reference pose. Empty without tendons.
std::vector<Suspicion> implausible_tendons(const Mechanism& mechanism);

}  // namespace sinew

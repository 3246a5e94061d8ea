// SPDX-License-Identifier: GPL-3.0-or-later
// Whether every joint of a mechanism moves some inertia.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "symbolic/model/mechanism.h"

namespace sinew {

/// Mass matrix [kg m^2, kg m, kg by the joints' types] at the coordinates q, from body Jacobians.
Eigen::MatrixXd mass_matrix_at(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// The joint that most takes part in a motion without inertia, if the mass matrix is singular
/// (an entry of the diagonal or an eigenvalue of the unit-diagonal form is a rounding error) at
/// every one of a few points spread over the joints' ranges. Singular at single points only, as a
/// spherical pendulum is: nothing.
std::optional<std::size_t> joint_without_inertia(const Mechanism& mechanism);

/// What a user is told of that: the joint, what is left out, and what to add.
std::optional<std::string> note_of_singular_mass_matrix(const Mechanism& mechanism);

}  // namespace sinew

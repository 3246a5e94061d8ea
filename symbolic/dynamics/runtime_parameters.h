// SPDX-License-Identifier: GPL-3.0-or-later
// Dynamics whose masses and gravity stay arguments, for identification and for hands that differ.
#pragma once

#include "generator/function.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// Argument `parameters`: gravity in the base frame (3, m/s^2), then the base parameters of each
/// link in coordinate order: J(xx), J(yy), J(xy), J(xz), J(yz), J(x1), J(y1) behind a revolute
/// joint, J(x1), J(y1), J(z1), m behind a prismatic one (kg m^2, kg m, kg). The ranges are the
/// mechanism's own values +-20 %.
Argument parameter_argument(const JointTree& tree);

/// Puts the argument's symbols where the tree has numbers.
void use_parameters(JointTree& tree, const Argument& parameters);

/// base_parameters(mass, com, inertia, gravity -> parameters): from the bodies' mass (kg), centre
/// of mass (m, body frame) and inertia about it (xx, yy, zz, xy, xz, yz; kg m^2, body axes), one
/// row a body in the mechanism's order.
Function base_parameters_function(const Mechanism& mechanism);

}  // namespace sinew

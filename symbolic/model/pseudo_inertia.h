// SPDX-License-Identifier: GPL-3.0-or-later
// A body's mass properties as one matrix (Wensing, Kim, Slotine 2018): some distribution of mass
// has them exactly where it is positive semidefinite.
#pragma once

#include <Eigen/Core>

#include "symbolic/model/mechanism.h"

namespace sinew {

/// [[S, h], [h^T, m]] about the body frame's origin: m [kg], h the first moments [kg m],
/// S = tr(I)/2 1 - I of the moments of inertia I [kg m^2] there.
Eigen::Matrix4d body_pseudo_inertia(const Body& body);

/// The same from I about the origin.
Eigen::Matrix4d pseudo_inertia_about_origin(double mass, const Eigen::Vector3d& first_moments,
                               const Eigen::Matrix3d& moments);

/// Moments of inertia about the origin [kg m^2].
Eigen::Matrix3d moments_of(const Eigen::Matrix4d& pseudo_inertia);

/// Of a point: the least moments of inertia that go with a mass > 0 and first moments.
Eigen::Matrix4d point_pseudo_inertia(double mass, const Eigen::Vector3d& first_moments);

/// Mass, centre of mass and inertia of that matrix, whose mass is not 0.
void set_pseudo_inertia(const Eigen::Matrix4d& J, Body& body);

/// Whether some distribution of mass has it: no eigenvalue below -1e-10, in units that make the
/// diagonal 1. Points and rods, whose eigenvalues are zero, are such.
bool is_physical(const Eigen::Matrix4d& J);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "symbolic/extension/identified.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// The mechanism with what logs taught about its links, its joints' sensors and its gravity:
///   payload and inertial_parameters at "link <body>": mass [kg], first_moment_x.. [kg m] and
///   moment_xx.. [kg m^2] about the body frame's origin, added to the body; without any moment a
///   payload is a point, and a link keeps its shape; gravity at "base": gravity_change_x.. [m/s^2];
///   sensor_offset at "<joint>": zero_offset [rad or m], what its sensor reads too much, so that
///   the coordinate stays the sensor's.
/// Throws DescriptionError for a link or joint that is not there, the zero of a joint that is
/// coupled with another one, a link that would have no mass, and one whose pseudo-inertia would not
/// be positive definite (that of points and rods: semidefinite).
Mechanism with_identified(Mechanism mechanism, const Identified& identified);

/// What `after` says of the mechanism beyond `before`.
Identified mechanism_changes(const Identified& before, const Identified& after);

/// Whether the entry is one of these.
bool changes_mechanism(const IdentifiedEffect& entry);
/// Whether it is about a link.
bool changes_link(const IdentifiedEffect& entry);

/// What an entry that changes a link adds to its pseudo-inertia (symbolic/model/pseudo_inertia.h).
Eigen::Matrix4d pseudo_inertia_of(const IdentifiedEffect& entry);

}  // namespace sinew

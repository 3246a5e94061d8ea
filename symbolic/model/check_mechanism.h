// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for any mechanism, wherever it was read from.
#pragma once

#include <optional>
#include <string>

#include "symbolic/files/description_error.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// How strictly an inertia is checked.
enum class InertiaCheck {
  physical,   ///< positive definite, and no principal moment above the sum of the other two
  idealised,  ///< as physical, but principal moments may be zero: point masses, thin rods
  as_given    ///< no negative principal moment; identified parameters may break the triangle rule
};

/// Relative margin of the triangle inequality. Tables print four digits or more; rounding to four
/// moves the largest principal moment and the sum of the others apart by up to 1e-3 of the largest.
inline constexpr double inertia_margin = 1e-3;

/// What is wrong with an inertia [kg m^2], or nothing.
std::optional<std::string> wrong_inertia(const Eigen::Matrix3d& inertia, InertiaCheck check);

/// The strictest check an inertia passes, or nothing if it passes none.
std::optional<InertiaCheck> strictest_check(const Eigen::Matrix3d& inertia);

std::string to_text(InertiaCheck check);

/// "principal moments 1, 2, 3 kg*m^2", for messages.
std::string principal_moments_text(const Eigen::Matrix3d& inertia);

/// The inertia with principal moments that rounding made negative (as -2.4e-35 kg m^2 of a body of
/// 10 g) set to zero; nothing where there are none. Rounding: below 1e-12 of the largest moment, or
/// of a radius of gyration below 1 nm, which no body has.
std::optional<Eigen::Matrix3d> without_negative_rounding(const Eigen::Matrix3d& inertia,
                                                         double mass);

/// Reports everything that keeps a mechanism from being derived: order of the bodies, names,
/// references, masses, inertias (as_given), axes and ranges. A singular mass matrix keeps nothing
/// but its inverse from being derived (singular_mass_matrix.h).
void check_mechanism(const Mechanism& mechanism, Findings& findings);

/// Throws DescriptionError where check_mechanism finds anything.
void require_sound(const Mechanism& mechanism);

}  // namespace sinew

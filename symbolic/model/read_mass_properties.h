// SPDX-License-Identifier: GPL-3.0-or-later
// The table of mass properties as a CAD program exports it.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "symbolic/files/description_error.h"

namespace sinew {

/// One row: a body's mass [kg], centre of mass [m, body frame] and inertia about the centre of mass
/// in body axes [kg m^2]; products of inertia are the tensor's entries (ixy = -integral of x y dm).
struct MassProperties {
  std::string body;
  double mass = 0.0;
  Eigen::Vector3d centre_of_mass = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  std::string provenance;  ///< "cad", "assumed: rod", ...
  SourceLocation where;
  SourceLocation mass_where;
  SourceLocation inertia_where;
};

/// Rows of a table with the columns link, mass, com_x, com_y, com_z, ixx, iyy, izz, ixy, ixz, iyz
/// and optionally iyx, izx, izy, from, ref and note, in any order; numbers' columns state their
/// unit, `mass [g]`. Reports mistakes in the table; a row with one is left out. Whether masses and
/// inertias are physical is for the caller, who knows the bodies.
std::vector<MassProperties> parse_mass_properties(std::string_view text, const std::string& file,
                                                  Findings& findings);

}  // namespace sinew

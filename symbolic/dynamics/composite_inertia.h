// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "symbolic/dynamics/spatial.h"

namespace sinew {

/// Pseudo-inertia [integral r r^T dm, integral r dm; ., m] as expressions; symmetric.
using PseudoInertia = std::array<std::array<GiNaC::ex, 4>, 4>;

PseudoInertia to_expression(const NumberMatrix4& J);

/// J turned by an angle about z: R J R^T. The planar block costs five operations a quadratic form:
/// Jxx' = b + c u, Jxy' = h + s u, Jyy' = a - c u with u = (a-b) c - 2 h s.
PseudoInertia turned(DefinitionList& list, const std::string& name, const CosSin& angle,
                     const PseudoInertia& J);

/// J seen from a frame in which its own frame's origin is at `offset`.
PseudoInertia shifted(DefinitionList& list, const std::string& name, const Vector3ex& offset,
                      const PseudoInertia& J);

/// R J R^T for constant R.
PseudoInertia rotated(DefinitionList& list, const std::string& name, const NumberMatrix3& R,
                      const PseudoInertia& J);

/// Element-wise sum.
PseudoInertia operator+(const PseudoInertia& a, const PseudoInertia& b);

}  // namespace sinew

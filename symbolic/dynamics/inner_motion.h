// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "symbolic/dynamics/composite_inertia.h"
#include "symbolic/dynamics/spatial.h"

namespace sinew {

/// How the masses beyond a joint move within a frame, as seen by somebody who sits in it: r from
/// its origin, dr relative to its axes. A rigid composite has none.
struct InnerMotion {
  Matrix3ex Q = zero_matrix();  ///< integral of r dr^T dm, kg m^2/s; not symmetric
  Vector3ex p = zero_vector();  ///< integral of dr dm, kg m/s
};

InnerMotion operator+(const InnerMotion& a, const InnerMotion& b);

/// Components after a turn by an angle about z.
InnerMotion turned(DefinitionList& list, const std::string& name, const CosSin& angle,
                   const InnerMotion& motion);

/// Components after a constant rotation.
InnerMotion rotated(DefinitionList& list, const std::string& name, const NumberMatrix3& R,
                    const InnerMotion& motion);

/// Seen from a frame in which the origin is at `offset` and stays there.
InnerMotion shifted(DefinitionList& list, const std::string& name, const Vector3ex& offset,
                    const InnerMotion& motion);

/// What a turning about z at `rate` adds, given the inertia of what turns.
InnerMotion turning(DefinitionList& list, const std::string& name, const GiNaC::ex& rate,
                    const PseudoInertia& J);

/// What a translation by q along z at `rate` adds: to the motion `before`, the inertia `slid` of
/// what slides, seen after the translation.
InnerMotion sliding(DefinitionList& list, const std::string& name, const GiNaC::ex& q,
                    const GiNaC::ex& rate, const InnerMotion& before, const PseudoInertia& slid);

}  // namespace sinew

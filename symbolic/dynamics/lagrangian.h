// SPDX-License-Identifier: GPL-3.0-or-later
// The equations of motion as a textbook writes them (5.4): L = T - V link by link, then
// tau = d/dt dL/dqd - dL/dq by differentiating what was written down. An independent statement of
// what recursive_lagrangian.h computes more cheaply; joint couplings enter through L itself, the
// second method of 5.3.2.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// L = T - V [J] with T = 1/2 sum (m v^T v + w^T I w) and V = -sum m g^T p, written as definitions.
/// `q`, `qd`: the mechanism's coordinates and their rates; a coupled joint has none of its own.
GiNaC::ex lagrangian(DefinitionList& list, const Mechanism& mechanism,
                     const std::vector<GiNaC::symbol>& q, const std::vector<GiNaC::symbol>& qd);

/// inverse_dynamics(q, qd, qdd -> tau) from it: generalised forces [N m, N].
Function textbook_inverse_dynamics(const Mechanism& mechanism);

/// The first method of 5.3.2: the model without couplings, its joints' motion replaced by what they
/// follow, and its torques projected on the coordinates, J^T tau. The second one is
/// textbook_inverse_dynamics, where the couplings stand in L itself.
Function projected_inverse_dynamics(const Mechanism& mechanism);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// The Coriolis matrix in Christoffel form without a single derivative of the mass matrix.
//
// The mass matrix M_ij = integral of dr/dq_i . dr/dq_j dm is the metric that the configuration
// space gets from the space its points move in, and so are its Christoffel symbols of the first
// kind those of an embedded surface: 1/2 (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) = integral of
// dr/dq_i . d2r/dq_j dq_k dm. Summed over k with qd_k,
//
//   C_ij = integral of dr/dq_i . d/dt(dr/dq_j) dm.
//
// With a_j the axis of a revolute joint and o_j its origin, dr/dq_j = a_j x (r - o_j), and its rate
// is da_j x (r - o_j) + a_j x (dr - do_j). Integrals of that over the masses beyond a joint m are
// composites as the mass matrix has them, and InnerMotion. They give, once a joint, everything that
// its row and its column need on the way to the base (JointSums): the cost grows with the square of
// the length, not with the cube.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/dynamics/dynamics_plan.h"
#include "symbolic/dynamics/joint_tree.h"

namespace sinew {

/// n x n, row-major, over definitions of a list.
struct CoriolisAndMass {
  std::vector<GiNaC::ex> C;  ///< dM/dt - 2 C is skew-symmetric
  std::vector<GiNaC::ex> M;  ///< comes along; what is not used of it costs nothing
};

/// C(q, qd) with C_ij = 1/2 sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) qd_k of all moving joints,
/// kg m^2/s (revolute), kg/s (prismatic), as definitions appended to `list`.
CoriolisAndMass coriolis_matrix(DefinitionList& list, const JointTree& tree,
                                const DynamicsPlan& plan, const std::vector<GiNaC::ex>& q,
                                const std::vector<GiNaC::ex>& qd);

}  // namespace sinew

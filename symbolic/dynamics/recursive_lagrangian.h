// SPDX-License-Identifier: GPL-3.0-or-later
// The Lagrangian's equations of motion with every partial result kept.
//
// With W_i(q) the pose of link i and J_i its pseudo-inertia, the Lagrangian is
//
//   L = sum_i  1/2 tr(dW_i J_i dW_i^T) + g^T W_i J_i e_4
//
// and d/dt dL/dqd_k - dL/dq_k collapses, for any L of this form, to
//
//   tau_k = sum_{i moved by k} tr( (dW_i/dq_k) J_i (ddW_i - [0 g; 0 0])^T ).
//
// Read backwards from tau, that is the adjoint of the pose recursion W_i = W_parent O_i(q_i): one
// sweep outwards carries ddW (angular velocity w, U = R^T ddR and acceleration a of each link), one
// sweep inwards carries the adjoint (force F and moment N). Nothing is expanded in between, so the
// cost is a small multiple of that of L itself, linear in the number of links.
//
// Runs of parallel axes are written in one frame {P} that does not turn: the quadratic form's parts
// that multiply the carrier's motion are composites over the run (K, S below), so that the
// carrier's rates multiply once per joint and not once per link.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/dynamics/dynamics_plan.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/runs.h"
#include "symbolic/dynamics/spatial.h"

namespace sinew {

/// State of the motion that the equations are written for. Zeros simplify: with qd = qdd = 0 the
/// result is gravity, with qdd = 0 the bias.
struct JointState {
  std::vector<GiNaC::ex> q, qd, qdd;
};

/// Generalised forces tau (N m, N), one a coordinate, written as definitions appended to `list`.
std::vector<GiNaC::ex> inverse_dynamics(DefinitionList& list, const JointTree& tree,
                                        const DynamicsPlan& plan, const JointState& state);

}  // namespace sinew

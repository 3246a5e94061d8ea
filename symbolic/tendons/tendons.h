// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <string>
#include <vector>

#include "symbolic/expressions/definition_list.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/model/mechanism.h"

namespace sinew {

/// Index of a body by name, -1 for "base". Throws std::invalid_argument where there is none.
int body_named(const Mechanism& mechanism, const std::string& name);

/// Path lengths h(q), m, one a tendon (5.5), (5.20): h0 + sum r q + sum |p_to - p_from|.
std::vector<GiNaC::ex> tendon_lengths(DefinitionList& list, const Mechanism& mechanism,
                                      const JointTree& tree, const std::vector<GiNaC::symbol>& q);

/// Coupling matrix P = dh/dq, m x n row-major, from the lengths.
std::vector<GiNaC::ex> coupling_matrix(DefinitionList& list, const std::vector<GiNaC::ex>& lengths,
                                       const std::vector<GiNaC::symbol>& q);

/// tau = -P^T f, f >= 0.
std::vector<GiNaC::ex> joint_torque(DefinitionList& list, const std::vector<GiNaC::ex>& P,
                                    const std::vector<GiNaC::symbol>& f, std::size_t n);

/// K = sum_i f_i d2h_i/dq2 + P^T diag(kt) P, n x n row-major, motors held.
std::vector<GiNaC::ex> joint_stiffness(DefinitionList& list, const std::vector<GiNaC::ex>& lengths,
                                       const std::vector<GiNaC::ex>& P,
                                       const std::vector<GiNaC::symbol>& q,
                                       const std::vector<GiNaC::symbol>& f,
                                       const std::vector<GiNaC::symbol>& kt);

/// q = P^+ (h - h(0)) for constant P of full column rank; nothing where P depends on q or the
/// tendons leave a joint free.
std::optional<std::vector<GiNaC::ex>> link_position(const Mechanism& mechanism,
                                                    const std::vector<GiNaC::ex>& P,
                                                    const std::vector<GiNaC::symbol>& h);

}  // namespace sinew

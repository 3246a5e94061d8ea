// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/definition_list.h"

namespace sinew {

/// C(q, qd) in Christoffel form, n x n row-major:
///   C_ij = 1/2 sum_k (dM_ij/dq_k + dM_ik/dq_j - dM_jk/dq_i) qd_k,
/// so that dM/dt - 2 C is skew-symmetric. `M` is n x n over definitions of `list`.
std::vector<GiNaC::ex> coriolis_matrix(DefinitionList& list, const std::vector<GiNaC::ex>& M,
                                       const std::vector<GiNaC::symbol>& q,
                                       const std::vector<GiNaC::ex>& qd);

}  // namespace sinew

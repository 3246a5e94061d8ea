// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "symbolic/expressions/definition_list.h"

namespace sinew {

/// Solution x of M x = b for symmetric positive definite M (n x n row-major), by M = L^T D L from
/// the last row to the first: zeros of M from separate branches stay zero, and there are n
/// divisions. No pivoting: M is positive definite for every physical mechanism.
std::vector<GiNaC::ex> solve_mass_matrix(DefinitionList& list, std::vector<GiNaC::ex> M,
                                         std::vector<GiNaC::ex> b);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/dynamics/forward_dynamics.h"

#include "symbolic/dynamics/spatial.h"

namespace sinew {

using GiNaC::ex;

std::vector<ex> solve_mass_matrix(DefinitionList& list, std::vector<ex> M, std::vector<ex> b) {
  const std::size_t n = b.size();
  const auto entry = [&](std::size_t i, std::size_t j) -> ex& { return M[i * n + j]; };
  std::vector<ex> reciprocal(n);
  for (std::size_t k = n; k-- > 0;) {
    const std::string row = std::to_string(k + 1);
    reciprocal[k] = list.define("r" + row, 1 / entry(k, k));
    for (std::size_t i = k; i-- > 0;) {
      const ex factor =
          named(list, "L" + row + "_" + std::to_string(i + 1), entry(k, i) * reciprocal[k]);
      for (std::size_t j = 0; j <= i; ++j)
        entry(i, j) = named(list, "A" + std::to_string(i + 1) + "_" + std::to_string(j + 1),
                            entry(i, j) - factor * entry(k, j));
      b[i] = named(list, "b" + std::to_string(i + 1), b[i] - factor * b[k]);
      entry(i, k) = factor;  // the upper half keeps L; the lower half keeps row k of M
    }
  }
  std::vector<ex> x(n);
  for (std::size_t i = 0; i < n; ++i) {
    ex value = b[i] * reciprocal[i];
    for (std::size_t j = 0; j < i; ++j) value -= entry(j, i) * x[j];
    x[i] = named(list, "x" + std::to_string(i + 1), value);
  }
  return x;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/coriolis.h"

#include "symbolic/differentiate.h"
#include "symbolic/spatial.h"

namespace sinew {

using GiNaC::ex;

std::vector<ex> coriolis_matrix(DefinitionList& list, const std::vector<ex>& M,
                                const std::vector<GiNaC::symbol>& q, const std::vector<ex>& qd) {
  const std::size_t n = q.size();
  std::vector<std::vector<ex>> slope(n, std::vector<ex>(n * n));  // slope[k] = dM/dq_k
  for (std::size_t k = 0; k < n; ++k) {
    ForwardDerivative derivative(list, q[k], q[k].get_name());
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j)
        slope[k][i * n + j] = slope[k][j * n + i] = named(
            list, "M" + std::to_string(i + 1) + std::to_string(j + 1) + "_by_" + q[k].get_name(),
            derivative.of(M[i * n + j]));
  }
  std::vector<ex> half(n);
  for (std::size_t k = 0; k < n; ++k)
    half[k] = named(list, "hq" + std::to_string(k + 1), qd[k] / 2);
  std::vector<ex> C(n * n, ex(0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k) {
        const ex symbol = slope[k][i * n + j] + slope[j][i * n + k] - slope[i][j * n + k];
        C[i * n + j] +=
            named(list, "G" + std::to_string(i + 1) + std::to_string(j + 1) + std::to_string(k + 1),
                  symbol) *
            half[k];
      }
  return C;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/body_limits.h"

#include <algorithm>
#include <cmath>

namespace sinew::diagnosis {

using Eigen::Index;
using Eigen::VectorXd;

bool is_body(const VectorXd& values, const VectorXd& errors, double reach) {
  const VectorXd most = values + 2.0 * errors;
  const VectorXd least = (values.cwiseAbs() - 2.0 * errors).cwiseMax(0.0);
  for (Index k = 4; k < std::min<Index>(values.size(), 7); ++k)
    if (most(k) < 0.0) return false;
  if (errors(0) == 0.0) return true;
  const double mass = std::max(0.0, most(0));
  for (Index k = 1; k < values.size(); ++k)
    if (least(k) > mass * (k < 4 ? reach : reach * reach)) return false;
  return true;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/logs/signal_relations.h"

#include <algorithm>
#include <cmath>

namespace sinew {

using Eigen::ArrayXd;

double rms(const ArrayXd& x) {
  return x.size() == 0 ? 0.0 : std::sqrt(x.square().mean());
}

ArrayXd centred(const ArrayXd& x) {
  return x - x.mean();
}

double correlation(const ArrayXd& a, const ArrayXd& b) {
  const ArrayXd ca = centred(a), cb = centred(b);
  const double scale = std::sqrt(ca.square().sum() * cb.square().sum());
  return scale > 0.0 ? (ca * cb).sum() / scale : 0.0;
}

double slope(const ArrayXd& y, const ArrayXd& x) {
  const ArrayXd cx = centred(x);
  const double power = cx.square().sum();
  return power > 0.0 ? (centred(y) * cx).sum() / power : 0.0;
}

ArrayXd moving_mean(const ArrayXd& x, long m) {
  const long n = x.size() - 2 * m;
  ArrayXd y(n);
  double sum = x.head(2 * m + 1).sum();
  const double scale = 1.0 / static_cast<double>(2 * m + 1);
  y(0) = sum * scale;
  for (long k = 1; k < n; ++k) {
    sum += x(k + 2 * m) - x(k - 1);
    y(k) = sum * scale;
  }
  return y;
}

}  // namespace sinew

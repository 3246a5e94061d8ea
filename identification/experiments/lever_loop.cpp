// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/experiments/lever_loop.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>

namespace sinew {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr int width_degree = 6;         // of the loop's width over the travel
constexpr Index rows_to_choose = 5000;  // enough to tell lengths apart
constexpr double lengths[] = {0.003, 0.006, 0.01, 0.016, 0.025, 0.04, 0.06, 0.09, 0.14, 0.2, 0.3};

/// The loop's columns first, then the force's.
MatrixXd columns_of(const ArrayXd& u, const ArrayXd& z, int highest) {
  MatrixXd columns(u.size(), width_degree + 1 + highest + 1);
  ArrayXd power = ArrayXd::Ones(u.size());
  for (int k = 0; k <= std::max(highest, width_degree); ++k, power *= u) {
    if (k <= width_degree) columns.col(k) = power * z;
    if (k <= highest) columns.col(width_degree + 1 + k) = power;
  }
  return columns;
}

/// Every n-th value.
ArrayXd thinned(const ArrayXd& x, Index every) {
  ArrayXd few(x.size() / every);
  for (Index i = 0; i < few.size(); ++i) few(i) = x(i * every);
  return few;
}

}  // namespace

ArrayXd loop_state(const ArrayXd& u, const std::vector<Index>& starts, double step, double length) {
  ArrayXd z(u.size());
  std::size_t next = 0;
  double state = 0.0, held = 0.0;
  for (Index i = 0; i < u.size(); ++i) {
    if (next < starts.size() && starts[next] == i) {
      state = 0.0;
      held = u(i);
      ++next;
    }
    const double ahead = u(i) - held;
    if (std::abs(ahead) > step) {
      const double way = ahead - std::copysign(step, ahead);
      held += way;
      const double left = std::exp(-std::abs(way) / length);
      state = way > 0.0 ? 1.0 - (1.0 - state) * left : (1.0 + state) * left - 1.0;
    }
    z(i) = state;
  }
  return z;
}

MiddleOfLoop middle_of_loop(const ArrayXd& u, const ArrayXd& force,
                            const std::vector<Index>& starts, double step, int highest) {
  const Index every = std::max<Index>(1, u.size() / rows_to_choose);
  const ArrayXd few_u = thinned(u, every), few_force = thinned(force, every);
  double least = std::numeric_limits<double>::infinity(), length = 0.0;
  const auto attempt = [&](double candidate) {
    const ArrayXd z = thinned(loop_state(u, starts, step, candidate), every);
    const MatrixXd columns = columns_of(few_u, z, highest);
    const Eigen::VectorXd c = columns.colPivHouseholderQr().solve(few_force.matrix());
    const double left = (columns * c - few_force.matrix()).squaredNorm();
    if (left >= least) return;
    least = left;
    length = candidate;
  };
  for (const double candidate : lengths) attempt(candidate);
  const double coarse = length;
  for (const double factor : {0.75, 0.83, 0.91, 1.1, 1.2, 1.33}) attempt(coarse * factor);
  const MatrixXd columns = columns_of(u, loop_state(u, starts, step, length), highest);
  const Eigen::VectorXd c = columns.colPivHouseholderQr().solve(force.matrix());
  return {force - (columns.leftCols(width_degree + 1) * c.head(width_degree + 1)).array(), length};
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/regression/starting_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sinew::diagnosis {
namespace {

double grid_value(const NonlinearParameter& p, int i) {
  if (p.grid <= 1) return p.logarithmic ? std::sqrt(p.low * p.high) : 0.5 * (p.low + p.high);
  const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(p.grid);
  return p.logarithmic ? p.low * std::pow(p.high / p.low, share) : p.low + share * (p.high - p.low);
}

}  // namespace

std::vector<Eigen::VectorXd> starting_values(const Candidate& candidate) {
  if (candidate.secant != 0.0)
    return {Eigen::VectorXd(), Eigen::VectorXd::Constant(1, candidate.secant)};
  std::vector<Eigen::VectorXd> values{
      Eigen::VectorXd(static_cast<Eigen::Index>(candidate.nonlinear.size()))};
  for (std::size_t k = 0; k < candidate.nonlinear.size(); ++k) {
    std::vector<Eigen::VectorXd> more;
    for (const Eigen::VectorXd& value : values)
      for (int i = 0; i < std::max(1, candidate.nonlinear[k].grid); ++i) {
        more.push_back(value);
        more.back()(static_cast<Eigen::Index>(k)) = grid_value(candidate.nonlinear[k], i);
      }
    values = std::move(more);
  }
  return values;
}

}  // namespace sinew::diagnosis

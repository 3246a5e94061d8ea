// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/tendons/pulling.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>

#include "symbolic/dynamics/coordinates.h"
#include "symbolic/expressions/evaluate_function.h"
#include "symbolic/files/readable.h"
#include "symbolic/tendons/tendon_motion.h"

namespace sinew {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Least squares of A x - b over the entries in `used`, the others 0.
VectorXd over_used(const MatrixXd& A, const VectorXd& b, const std::vector<Index>& used) {
  VectorXd x = VectorXd::Zero(A.cols());
  if (used.empty()) return x;
  const VectorXd part = A(Eigen::all, used).completeOrthogonalDecomposition().solve(b);
  for (std::size_t k = 0; k < used.size(); ++k) x[used[k]] = part[static_cast<Index>(k)];
  return x;
}

std::vector<Index> positive_of(const VectorXd& x) {
  std::vector<Index> used;
  for (Index i = 0; i < x.size(); ++i)
    if (x[i] > 0.0) used.push_back(i);
  return used;
}

/// min |A x - b| over x >= 0, by Lawson and Hanson (Solving Least Squares Problems, 1974).
VectorXd nonnegative_least_squares(const MatrixXd& A, const VectorXd& b) {
  const double tiny = 1e-12 * (A.norm() * b.norm() + 1.0);
  VectorXd x = VectorXd::Zero(A.cols());
  for (Index step = 0; step < 10 * A.cols(); ++step) {
    VectorXd gain = A.transpose() * (b - A * x);
    for (const Index i : positive_of(x)) gain[i] = 0.0;
    Index best = 0;
    if (gain.size() == 0 || gain.maxCoeff(&best) <= tiny) break;
    std::vector<Index> used = positive_of(x);
    used.push_back(best);
    VectorXd next = over_used(A, b, used);
    if (next[best] <= 0.0) break;  // rounding: nothing is gained
    while (true) {
      double share = 1.0;
      for (const Index i : used)
        if (next[i] <= 0.0) share = std::min(share, x[i] / (x[i] - next[i]));
      if (share >= 1.0) break;
      x += share * (next - x);
      for (const Index i : used)
        if (x[i] <= 1e-14 * x.cwiseAbs().maxCoeff()) x[i] = 0.0;
      used = positive_of(x);
      next = over_used(A, b, used);
    }
    x = next;
  }
  return x;
}

/// P = dh/dq at the reference pose, m x n.
MatrixXd coupling_at_reference(const Mechanism& mechanism) {
  const Function motion = tendon_motion_function(mechanism);
  std::vector<double> inputs;
  for (const Argument& argument : motion.inputs)
    for (std::size_t i = 0; i < argument.symbols.size(); ++i)
      inputs.push_back(i < argument.reference.size() ? argument.reference[i] : 0.0);
  const std::vector<double> values = evaluate(motion, inputs);
  const auto m = static_cast<Index>(motion.outputs.front().rows),
             n = static_cast<Index>(motion.outputs.front().cols);
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      values.data(), m, n);
}

}  // namespace

std::optional<VectorXd> motion_against_all(const MatrixXd& P) {
  MatrixXd rows = P;
  for (Index i = 0; i < rows.rows(); ++i)  // how large a tension is does not matter
    if (rows.row(i).norm() > 0.0) rows.row(i).normalize();
  const VectorXd ones = VectorXd::Ones(rows.rows());
  const VectorXd more = nonnegative_least_squares(rows.transpose(), -rows.transpose() * ones);
  const VectorXd left = rows.transpose() * (ones + more);
  if (left.norm() <= 1e-9 * (ones + more).norm()) return std::nullopt;
  return left / left.cwiseAbs().maxCoeff();
}

std::vector<Suspicion> implausible_tendons(const Mechanism& mechanism) {
  std::vector<Suspicion> found;
  if (mechanism.tendons.empty()) return found;
  const MatrixXd P = coupling_at_reference(mechanism);
  const Coordinates coordinates(mechanism);
  const auto joint = [&](Index k) -> const Joint& {
    return mechanism
        .joints[static_cast<std::size_t>(coordinates.joints()[static_cast<std::size_t>(k)])];
  };
  Index reached = 0;
  for (Index k = 0; k < P.cols(); ++k) {
    const bool is_reached = P.col(k).norm() > 1e-9 * P.norm();
    reached += is_reached;
    if (!is_reached)
      found.push_back({joint(k).where,
                       fmt::format("no tendon reaches joint '{}'; nothing drives or holds it: is a "
                                   "pulley missing, or should the joint be fixed?",
                                   joint(k).name)});
  }
  const SourceLocation where = mechanism.tendons.front().where;
  Eigen::ColPivHouseholderQR<MatrixXd> decomposition(P);
  decomposition.setThreshold(1e-9);
  const Index rank = decomposition.rank();
  if (rank < reached)
    found.push_back(
        {where, fmt::format("the coupling matrix P has rank {} for the {} joints that tendons "
                            "reach; some joints cannot be moved apart from each other: are rows or "
                            "signs of the pulleys' radii the same that should differ?",
                            rank, reached)});
  if (const auto motion = motion_against_all(P)) {
    std::vector<std::string> names;
    for (Index k = 0; k < motion->size(); ++k)
      if (std::abs((*motion)[k]) > 0.01) names.push_back(joint(k).name);
    found.push_back({where, fmt::format("no tensions balance each other (no force closure): the "
                                        "tendons at {} pull one way only, and tendons cannot push; "
                                        "is an antagonist missing, or the sign of a radius wrong?",
                                        listed(names))});
  }
  return found;
}

}  // namespace sinew

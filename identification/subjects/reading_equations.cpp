// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/reading_equations.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/subjects/column_readings.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostSteps = 30;

/// Products of one effort's columns, as shares of how much the effort changes.
struct Products {
  std::vector<Index> at;  ///< unknowns
  MatrixXd gram;
  VectorXd right;
  double left = 1.0;  ///< with every unknown zero

  double share(const VectorXd& c) const {
    const VectorXd own = c(at);
    return std::max(0.0, left - 2.0 * right.dot(own) + own.dot(gram * own));
  }
  bool is_finite() const { return std::isfinite(left) && gram.allFinite() && right.allFinite(); }
};

VectorXd centred(const VectorXd& x) {
  return x.array() - x.mean();
}

/// An effort that does not change tells nothing.
bool tells(const EffortEquation& equation) {
  return equation.measured.size() > 0 && centred(equation.measured).squaredNorm() > 0.0;
}

Products products_of(const EffortEquation& equation) {
  const double whole = centred(equation.measured).squaredNorm();
  const VectorXd left = equation.measured - equation.said;
  MatrixXd x(left.size(), static_cast<Index>(equation.terms.size()));
  Products products;
  for (const EffortEquation::Term& term : equation.terms) {
    x.col(static_cast<Index>(products.at.size())) = term.column;
    products.at.push_back(term.unknown);
  }
  products.gram = x.transpose() * x / whole;
  products.right = x.transpose() * left / whole;
  products.left = left.squaredNorm() / whole;
  return products;
}

/// Minus the logarithm of the likelihood and of the unknowns' densities.
class Misfit {
 public:
  Misfit(std::vector<Products> efforts, const std::vector<Unknown>& unknowns)
      : efforts_(std::move(efforts)), unknowns_(unknowns) {}

  /// The better end of two descents: from the drawing, and from what the efforts alone ask for.
  double least() const {
    const auto count = static_cast<Index>(unknowns_.size());
    const VectorXd drawn = VectorXd::Zero(count);
    const VectorXd free = VectorXd::Constant(count, 1e-9);
    const std::vector<double> alike(efforts_.size(), 1.0);
    return std::min(descended(drawn), descended(weighed(alike, free)));
  }

 private:
  double value(const VectorXd& c) const {
    double sum = 0.0;
    for (const Products& effort : efforts_) sum -= evidence_of_share(effort.share(c));
    for (Index k = 0; k < c.size(); ++k)
      sum += improbability(unknowns_[static_cast<std::size_t>(k)], c(k));
    return sum;
  }

  static double improbability(const Unknown& unknown, double c) {
    const bool lacks = unknown.kind == Unknown::Kind::share && c < 0.0;
    const double off = (lacks ? c / std::max(1e-9, 1.0 + c) : c) / unknown.spread;
    return unknown.kind == Unknown::Kind::fixed ? 0.5 * off * off : std::log1p(off * off);
  }

  /// Slope of improbability() over the square.
  static double weight_of(const Unknown& unknown, double c) {
    const double square = unknown.spread * unknown.spread;
    if (unknown.kind == Unknown::Kind::fixed) return 0.5 / square;
    if (unknown.kind == Unknown::Kind::share && c < 0.0) {
      const double left = std::max(1e-9, 1.0 + c);
      return 1.0 / (left * (square * left * left + c * c));
    }
    return 1.0 / (square + c * c);
  }

  /// Least squares with a weight for each effort and for each unknown's square. What is only added
  /// is left out where it would be taken.
  VectorXd weighed(const std::vector<double>& of_effort, const VectorXd& of_unknown) const {
    const Index n = of_unknown.size();
    MatrixXd gram = of_unknown.asDiagonal();
    VectorXd right = VectorXd::Zero(n), c = VectorXd::Zero(n);
    for (std::size_t e = 0; e < efforts_.size(); ++e) {
      gram(efforts_[e].at, efforts_[e].at) += of_effort[e] * efforts_[e].gram;
      right(efforts_[e].at) += of_effort[e] * efforts_[e].right;
    }
    std::vector<Index> in;
    for (Index k = 0; k < n; ++k) in.push_back(k);
    while (!in.empty()) {
      const VectorXd some = gram(in, in).ldlt().solve(right(in));
      if (!some.allFinite()) return VectorXd::Zero(n);
      std::vector<Index> kept;
      for (Index i = 0; i < some.size(); ++i) {
        const Index k = in[static_cast<std::size_t>(i)];
        const bool added = unknowns_[static_cast<std::size_t>(k)].kind == Unknown::Kind::added;
        if (!added || some(i) >= 0.0) kept.push_back(k);
      }
      if (kept.size() == in.size()) {
        c(in) = some;
        return c;
      }
      in = kept;
    }
    return c;
  }

  /// Each step minimises what touches value() here and lies above it everywhere.
  double descended(VectorXd c) const {
    double now = value(c);
    for (int step = 0; step < kMostSteps; ++step) {
      std::vector<double> slopes;
      for (const Products& effort : efforts_) slopes.push_back(slope_at(effort.share(c)));
      VectorXd weights(c.size());
      for (Index k = 0; k < c.size(); ++k)
        weights(k) = weight_of(unknowns_[static_cast<std::size_t>(k)], c(k));
      c = weighed(slopes, weights);
      const double then = value(c);
      if (!(then < now - 1e-2)) return std::min(then, now);
      now = then;
    }
    return now;
  }

  /// Of -evidence_of_share().
  static double slope_at(double share) {
    const double step = 1e-3 * share + 1e-9;
    return (evidence_of_share(share) - evidence_of_share(share + step)) / step;
  }

  std::vector<Products> efforts_;
  const std::vector<Unknown>& unknowns_;
};

}  // namespace

double evidence_of(const std::vector<EffortEquation>& equations,
                   const std::vector<Unknown>& unknowns) {
  std::vector<Products> efforts;
  for (const EffortEquation& equation : equations) {
    if (!tells(equation)) continue;
    efforts.push_back(products_of(equation));
    if (!efforts.back().is_finite()) return -std::numeric_limits<double>::infinity();
  }
  return -Misfit(std::move(efforts), unknowns).least();
}

}  // namespace sinew::diagnosis

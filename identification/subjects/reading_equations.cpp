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
// Unknowns that are freed one by one: work, since an arm has more than seventy. With 4, 8 and 16
// the same is told of the tests and of a null that was refused without; stopping at the first one
// that gains nothing refuses that null again.
constexpr Index kMostFreed = 8;
// Weight of the square of an unknown that nothing holds, against 1 of the efforts: rounding's.
constexpr double kFree = 1e-9;

/// Products of one effort's columns, as shares of how much the effort changes.
struct Products {
  std::vector<Index> at;  ///< unknowns
  MatrixXd gram;
  VectorXd right;
  double left = 1.0;  ///< with every unknown zero
  double stretches = 0.0;

  double share(const VectorXd& c) const {
    const VectorXd own = c(at);
    return std::max(0.0, left - 2.0 * right.dot(own) + own.dot(gram * own));
  }
  double evidence(double share) const { return evidence_of_share(share, stretches); }
  /// Of -evidence().
  double slope_at(double share) const {
    const double step = 1e-3 * share + 1e-9;
    return (evidence(share) - evidence(share + step)) / step;
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
  products.stretches = equation.stretches;
  return products;
}

/// Minus the logarithm of the likelihood and of the unknowns' densities.
class Misfit {
 public:
  Misfit(std::vector<Products> efforts, const std::vector<Unknown>& unknowns)
      : efforts_(std::move(efforts)), unknowns_(unknowns) {}

  /// The best end of three descents: from the drawing, from what the efforts alone ask for, and
  /// from what few unknowns make of it. Tails as long as Cauchy's have several ends: few unknowns
  /// that are far off, or many that are a little.
  VectorXd likeliest() const {
    const auto count = static_cast<Index>(unknowns_.size());
    const std::vector<double> alike(efforts_.size(), 1.0);
    const VectorXd drawn = VectorXd::Zero(count),
                   free = weighed(alike, VectorXd::Constant(count, kFree));
    const VectorXd ends[] = {descended(drawn), descended(free), descended(pursued())};
    return *std::ranges::min_element(ends, {}, [&](const VectorXd& c) { return value(c); });
  }

  double value(const VectorXd& c) const {
    double sum = 0.0;
    for (const Products& effort : efforts_) sum -= effort.evidence(effort.share(c));
    for (Index k = 0; k < c.size(); ++k)
      sum += improbability(unknowns_[static_cast<std::size_t>(k)], c(k));
    return sum;
  }

 private:
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

  std::vector<double> slopes_at(const VectorXd& c) const {
    std::vector<double> slopes;
    for (const Products& effort : efforts_) slopes.push_back(effort.slope_at(effort.share(c)));
    return slopes;
  }

  /// One unknown after the other is freed, each time the one that makes most likely what is left.
  VectorXd pursued() const {
    const auto count = static_cast<Index>(unknowns_.size());
    VectorXd best = VectorXd::Zero(count), c = best,
             weights = VectorXd::Constant(count, 1.0 / kFree);
    double least = value(best);
    for (Index step = 0; step < std::min(count, kMostFreed); ++step) {
      const std::vector<double> slopes = slopes_at(c);
      const Index next = most_telling(c, slopes, weights);
      if (next < 0) break;
      weights(next) = kFree;
      c = weighed(slopes, weights);
      if (const double now = value(c); now < least) least = now, best = c;
    }
    return best;
  }

  /// Of the unknowns that are held, the one that by itself makes most likely what is left; -1:
  /// there is none.
  Index most_telling(const VectorXd& c, const std::vector<double>& slopes,
                     const VectorXd& weights) const {
    VectorXd pull = VectorXd::Zero(c.size()), stiffness = VectorXd::Zero(c.size());
    for (std::size_t e = 0; e < efforts_.size(); ++e) {
      const Products& effort = efforts_[e];
      const VectorXd left = effort.right - effort.gram * c(effort.at);
      pull(effort.at) += slopes[e] * left;
      stiffness(effort.at) += slopes[e] * effort.gram.diagonal();
    }
    Index found = -1;
    double least = std::numeric_limits<double>::infinity();
    for (Index k = 0; k < c.size(); ++k) {
      if (weights(k) == kFree || !(stiffness(k) > 0.0)) continue;
      VectorXd moved = c;
      moved(k) += pull(k) / stiffness(k);
      if (unknowns_[static_cast<std::size_t>(k)].kind == Unknown::Kind::added && moved(k) < 0.0)
        continue;
      if (const double now = value(moved); now < least) least = now, found = k;
    }
    return found;
  }

  /// Each step minimises what touches value() here and lies above it everywhere.
  VectorXd descended(VectorXd c) const {
    double now = value(c);
    for (int step = 0; step < kMostSteps; ++step) {
      VectorXd weights(c.size());
      for (Index k = 0; k < c.size(); ++k)
        weights(k) = weight_of(unknowns_[static_cast<std::size_t>(k)], c(k));
      VectorXd next = weighed(slopes_at(c), weights);
      const double then = value(next);
      if (then < now) c = std::move(next);
      if (!(then < now - 1e-2)) break;
      now = then;
    }
    return c;
  }

  std::vector<Products> efforts_;
  const std::vector<Unknown>& unknowns_;
};

}  // namespace

Explained explained_by(const std::vector<EffortEquation>& equations,
                       const std::vector<Unknown>& unknowns) {
  std::vector<Products> efforts;
  std::vector<std::size_t> at;
  Explained explained{-std::numeric_limits<double>::infinity(),
                      std::vector<double>(equations.size(), 1.0)};
  for (std::size_t i = 0; i < equations.size(); ++i) {
    if (!tells(equations[i])) continue;
    efforts.push_back(products_of(equations[i]));
    at.push_back(i);
    if (!efforts.back().is_finite()) return explained;
  }
  const Misfit misfit(efforts, unknowns);
  const VectorXd likeliest = misfit.likeliest();
  explained.log_likelihood = -misfit.value(likeliest);
  std::ranges::fill(explained.left, 0.0);
  for (std::size_t e = 0; e < efforts.size(); ++e)
    explained.left[at[e]] = efforts[e].share(likeliest);
  return explained;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// The sparsest set of parameter deviations, found on the moments of their columns.
#pragma once

#include <Eigen/Core>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace sinew::diagnosis {

/// Indices of deviations.
using DeviationSet = std::vector<int>;

/// All deviations' whitened columns with the base model projected out, as moments.
struct DeviationMoments {
  std::vector<Eigen::Index> first;  ///< column of each deviation's first parameter, and the total
  Eigen::MatrixXd gram;
  Eigen::VectorXd target;
  Eigen::MatrixXd surrogates;
  Eigen::VectorXd low, high;
  std::vector<std::optional<double>> body_within;  ///< each deviation's; see candidate.h
  double base = 0.0;  ///< deviance with every deviation at its nominal value
};

/// Drop of the deviance by a set; negative where a change lies beyond its limit by more than two
/// standard errors, or is that of no body.
double drop(const DeviationMoments& m, const DeviationSet& set);

DeviationSet without(DeviationSet set, int deviation);

/// The sparse search over sets of allowed deviations.
class DeviationSearch {
 public:
  /// Deviance that a deviation has to be worth.
  struct Price {
    double each_parameter, each_deviation;
  };
  /// Parameters count as effective ones; at most `most` deviations.
  DeviationSearch(const DeviationMoments& m, const Price& price, int most);

  /// Effective parameters of a deviation: what it takes of a surrogate's deviance on average.
  double freedom(int deviation) const { return freedom_[static_cast<std::size_t>(deviation)]; }

  /// Deviance beside a set, and its price; infinite beyond a limit.
  double score(DeviationSet set) const;

  /// Best set found from the most promising single deviations on by adding, removing and
  /// exchanging.
  DeviationSet best(const std::vector<bool>& banned) const;

 private:
  std::vector<DeviationSet> starts(const std::vector<bool>& banned) const;
  double descend(const std::vector<bool>& banned, DeviationSet& set) const;
  double deviance_and_price(const DeviationSet& set) const;

  const DeviationMoments& m_;
  std::size_t most_;
  std::vector<double> price_, freedom_;
  mutable std::mutex guard_;
  mutable std::map<DeviationSet, double> scores_;
};

/// Bonferroni over the deviations of the probability that a set gains that much by one of them.
double p_value(const DeviationMoments& m, const DeviationSet& set, int deviation, double statistic);

/// The deviation of a set that does most of what others of the set undo, far more than is left of
/// them together: large errors that happen to cancel are none. They come from columns that share a
/// noise with the target, or from a form that no deviation has.
std::optional<int> cancelled(const DeviationMoments& m, const DeviationSet& set);

}  // namespace sinew::diagnosis

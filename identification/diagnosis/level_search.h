// SPDX-License-Identifier: GPL-3.0-or-later
// The sparsest set of level causes, found on the moments of their columns.
#pragma once

#include <Eigen/Core>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace sinew::diagnosis {

/// Indices of levels.
using LevelSet = std::vector<int>;

/// All levels' whitened columns with the base model projected out, as moments.
struct LevelMoments {
  std::vector<Eigen::Index> first;  ///< column of each level's first parameter, and the total
  Eigen::MatrixXd gram;
  Eigen::VectorXd target;
  Eigen::MatrixXd surrogates;
  Eigen::VectorXd low, high;
  std::vector<std::optional<double>> body_within;  ///< each level's; see candidate.h
  std::vector<double> dearer;                      ///< what each level costs beside its parameters
  double base = 0.0;  ///< deviance with every level at its nominal value
};

/// Drop of the deviance by a set; negative where a change lies beyond its limit by more than two
/// standard errors, or is that of no body.
double drop(const LevelMoments& m, const LevelSet& set);

LevelSet without(LevelSet set, int level);

/// The sparse search over sets of allowed levels.
class LevelSearch {
 public:
  /// `price` per effective parameter; at most `most` levels.
  LevelSearch(const LevelMoments& m, double price, int most, int threads);

  /// Effective parameters of a level: what it takes of a surrogate's deviance on average.
  double freedom(int level) const { return freedom_[static_cast<std::size_t>(level)]; }

  /// Deviance beside a set, and its price; infinite beyond a limit.
  double score(LevelSet set) const;

  /// Best set found from the most promising single levels on by adding, removing and exchanging.
  LevelSet best(const std::vector<bool>& banned) const;

 private:
  std::vector<LevelSet> starts(const std::vector<bool>& banned) const;
  double descend(const std::vector<bool>& banned, LevelSet& set) const;
  double deviance_and_price(const LevelSet& set) const;

  const LevelMoments& m_;
  std::size_t most_;
  int threads_;
  std::vector<double> price_, freedom_;
  mutable std::mutex guard_;
  mutable std::map<LevelSet, double> scores_;
};

/// Bonferroni over the levels of the probability that a set gains that much by one of them.
double p_value(const LevelMoments& m, const LevelSet& set, int level, double statistic);

/// The level of a set that does most of what others of the set undo, far more than is left of them
/// together: large errors that happen to cancel are none. They come from columns that share a noise
/// with the target, or from a form that no level has.
std::optional<int> cancelled(const LevelMoments& m, const LevelSet& set);

}  // namespace sinew::diagnosis

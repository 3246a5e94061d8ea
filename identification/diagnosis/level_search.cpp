// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/level_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/regression/body_limits.h"
#include "identification/regression/linear_fit.h"
#include "identification/logs/parallel_for.h"
#include "identification/regression/surrogates.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kStarts = 24;  // of the search: twice a finger's channels

std::vector<Index> indices(const LevelMoments& m, const LevelSet& set) {
  std::vector<Index> list;
  for (const int level : set)
    for (Index c = m.first[static_cast<std::size_t>(level)];
         c < m.first[static_cast<std::size_t>(level) + 1]; ++c)
      list.push_back(c);
  return list;
}

/// Drop of every surrogate's deviance by a set, without limits.
VectorXd drops_by_chance(const LevelMoments& m, const LevelSet& set) {
  const std::vector<Index> at = indices(m, set);
  if (at.empty()) return VectorXd::Zero(m.surrogates.cols());
  const MatrixXd moment = m.surrogates(at, Eigen::all);
  return (moment.cwiseProduct(scaled_pseudo_inverse(m.gram(at, at), 1e-8) * moment))
      .colwise()
      .sum()
      .transpose();
}

}  // namespace

double drop(const LevelMoments& m, const LevelSet& set) {
  const std::vector<Index> at = indices(m, set);
  if (at.empty()) return 0.0;
  const MatrixXd inverse = scaled_pseudo_inverse(m.gram(at, at), 1e-8);
  const VectorXd value = inverse * m.target(at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto k = static_cast<Index>(i);
    const double slack = 2.0 * std::sqrt(std::max(0.0, inverse(k, k)));
    if (value(k) < m.low(at[i]) - slack || value(k) > m.high(at[i]) + slack) return -1.0;
  }
  const VectorXd errors = inverse.diagonal().cwiseMax(0.0).cwiseSqrt();
  Index first = 0;
  for (const int level : set) {
    const auto l = static_cast<std::size_t>(level);
    const Index wide = m.first[l + 1] - m.first[l];
    const bool limited = l < m.body_within.size() && m.body_within[l];
    if (limited &&
        !is_body(value.segment(first, wide), errors.segment(first, wide), *m.body_within[l]))
      return -1.0;
    first += wide;
  }
  return value.dot(VectorXd(m.target(at)));
}

LevelSet without(LevelSet set, int level) {
  std::erase(set, level);
  return set;
}

LevelSearch::LevelSearch(const LevelMoments& m, double price, int most, int threads)
    : m_(m), most_(static_cast<std::size_t>(most)), threads_(threads) {
  for (int l = 0; l + 1 < static_cast<int>(m.first.size()); ++l) {
    const double freedom =
        m.surrogates.size() ? std::max(0.5, drops_by_chance(m, {l}).mean()) : 1.0;
    freedom_.push_back(freedom);
    price_.push_back(price * freedom + m.dearer[static_cast<std::size_t>(l)]);
  }
}

// From whatever start, a search meets the same sets again and again.
double LevelSearch::score(LevelSet set) const {
  std::sort(set.begin(), set.end());
  {
    const std::lock_guard<std::mutex> lock(guard_);
    const auto known = scores_.find(set);
    if (known != scores_.end()) return known->second;
  }
  const double value = deviance_and_price(set);
  const std::lock_guard<std::mutex> lock(guard_);
  return scores_.emplace(std::move(set), value).first->second;
}

LevelSet LevelSearch::best(const std::vector<bool>& banned) const {
  LevelSet found;
  double least = score(found);
  std::vector<LevelSet> sets = starts(banned);
  std::vector<double> scores(sets.size());
  parallel_for(static_cast<int>(sets.size()), threads_, [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    scores[k] = descend(banned, sets[k]);
  });
  for (std::size_t k = 0; k < sets.size(); ++k) {
    if (scores[k] >= least - 1e-9) continue;
    least = scores[k];
    found = sets[k];
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// No level, and the single ones with the best scores.
std::vector<LevelSet> LevelSearch::starts(const std::vector<bool>& banned) const {
  std::vector<LevelSet> sets;
  for (int l = 0; l < static_cast<int>(price_.size()); ++l)
    if (!banned[static_cast<std::size_t>(l)]) sets.push_back({l});
  std::stable_sort(sets.begin(), sets.end(),
                   [&](const LevelSet& a, const LevelSet& b) { return score(a) < score(b); });
  if (sets.size() > kStarts) sets.resize(kStarts);
  sets.insert(sets.begin(), LevelSet{});
  return sets;
}

double LevelSearch::descend(const std::vector<bool>& banned, LevelSet& set) const {
  double now = score(set);
  for (bool exchanging = false;;) {
    LevelSet next = set;
    double least = now - 1e-9;
    const auto consider = [&](LevelSet trial) {
      const double value = score(trial);
      if (value >= least) return;
      least = value;
      next = std::move(trial);
    };
    for (const int level : set) consider(without(set, level));
    for (int l = 0; l < static_cast<int>(price_.size()); ++l) {
      if (banned[static_cast<std::size_t>(l)] || std::count(set.begin(), set.end(), l)) continue;
      LevelSet more = set;
      more.push_back(l);
      if (!exchanging && more.size() <= most_) consider(more);
      // Exchanges are many: only where nothing else helps.
      if (exchanging)
        for (const int level : set) consider(without(more, level));
    }
    if (least >= now - 1e-9) {
      if (exchanging) return now;
      exchanging = true;
      continue;
    }
    exchanging = false;
    set = std::move(next);
    now = least;
  }
}

double LevelSearch::deviance_and_price(const LevelSet& set) const {
  const double gained = drop(m_, set);
  if (gained < 0.0) return std::numeric_limits<double>::infinity();
  double sum = m_.base - gained;
  for (const int level : set) sum += price_[static_cast<std::size_t>(level)];
  return sum;
}

double p_value(const LevelMoments& m, const LevelSet& set, int level, double statistic) {
  if (m.surrogates.size() == 0) return 1.0;
  const NullDistribution null(drops_by_chance(m, set) - drops_by_chance(m, without(set, level)));
  const double single = std::exp(-null.surprise(statistic));
  return std::min(1.0, single * static_cast<double>(m.first.size() - 1));
}

std::optional<int> cancelled(const LevelMoments& m, const LevelSet& set) {
  constexpr double kMost = 25.0;  // times the energy of all together
  const std::vector<Index> at = indices(m, set);
  if (at.empty()) return std::nullopt;
  const MatrixXd gram = m.gram(at, at);
  const VectorXd value = scaled_pseudo_inverse(gram, 1e-8) * VectorXd(m.target(at));
  double largest = kMost * value.dot(gram * value);
  std::optional<int> found;
  Index first = 0;
  for (const int level : set) {
    const Index wide = static_cast<Index>(indices(m, {level}).size());
    const VectorXd own = value.segment(first, wide);
    const double energy = own.dot(gram.block(first, first, wide, wide) * own);
    first += wide;
    if (energy <= largest) continue;
    largest = energy;
    found = level;
  }
  return found;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/deviation_search.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "identification/regression/body_limits.h"
#include "identification/regression/linear_fit.h"
#include "identification/regression/surrogates.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kStarts = 24;  // of the search: twice a finger's channels

std::vector<Index> indices(const DeviationMoments& m, const DeviationSet& set) {
  std::vector<Index> list;
  for (const int deviation : set)
    for (Index c = m.first[static_cast<std::size_t>(deviation)];
         c < m.first[static_cast<std::size_t>(deviation) + 1]; ++c)
      list.push_back(c);
  return list;
}

/// Drop of every surrogate's deviance by a set, without limits.
VectorXd drops_by_chance(const DeviationMoments& m, const DeviationSet& set) {
  const std::vector<Index> at = indices(m, set);
  if (at.empty()) return VectorXd::Zero(m.surrogates.cols());
  const MatrixXd moment = m.surrogates(at, Eigen::all);
  return (moment.cwiseProduct(scaled_pseudo_inverse(m.gram(at, at), 1e-8) * moment))
      .colwise()
      .sum()
      .transpose();
}

}  // namespace

double drop(const DeviationMoments& m, const DeviationSet& set) {
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
  for (const int deviation : set) {
    const auto l = static_cast<std::size_t>(deviation);
    const Index wide = m.first[l + 1] - m.first[l];
    const bool limited = l < m.body_within.size() && m.body_within[l];
    if (limited &&
        !is_body(value.segment(first, wide), errors.segment(first, wide), *m.body_within[l]))
      return -1.0;
    first += wide;
  }
  return value.dot(VectorXd(m.target(at)));
}

DeviationSet without(DeviationSet set, int deviation) {
  std::erase(set, deviation);
  return set;
}

DeviationSearch::DeviationSearch(const DeviationMoments& m, const Price& price, int most)
    : m_(m), most_(static_cast<std::size_t>(most)) {
  for (int l = 0; l + 1 < static_cast<int>(m.first.size()); ++l) {
    const double freedom =
        m.surrogates.size() ? std::max(0.5, drops_by_chance(m, {l}).mean()) : 1.0;
    freedom_.push_back(freedom);
    price_.push_back(price.each_parameter * freedom + price.each_deviation);
  }
}

// From whatever start, a search meets the same sets again and again.
double DeviationSearch::score(DeviationSet set) const {
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

DeviationSet DeviationSearch::best(const std::vector<bool>& banned) const {
  DeviationSet found;
  double least = score(found);
  std::vector<DeviationSet> sets = starts(banned);
  std::vector<double> scores(sets.size());
  tbb::parallel_for(0, static_cast<int>(sets.size()), [&](int i) {
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

/// No deviation, and the single ones with the best scores.
std::vector<DeviationSet> DeviationSearch::starts(const std::vector<bool>& banned) const {
  std::vector<DeviationSet> sets;
  for (int l = 0; l < static_cast<int>(price_.size()); ++l)
    if (!banned[static_cast<std::size_t>(l)]) sets.push_back({l});
  std::stable_sort(sets.begin(), sets.end(), [&](const DeviationSet& a, const DeviationSet& b) {
    return score(a) < score(b);
  });
  if (sets.size() > kStarts) sets.resize(kStarts);
  sets.insert(sets.begin(), DeviationSet{});
  return sets;
}

double DeviationSearch::descend(const std::vector<bool>& banned, DeviationSet& set) const {
  double now = score(set);
  for (bool exchanging = false;;) {
    DeviationSet next = set;
    double least = now - 1e-9;
    const auto consider = [&](DeviationSet trial) {
      const double value = score(trial);
      if (value >= least) return;
      least = value;
      next = std::move(trial);
    };
    for (const int deviation : set) consider(without(set, deviation));
    for (int l = 0; l < static_cast<int>(price_.size()); ++l) {
      if (banned[static_cast<std::size_t>(l)] || std::count(set.begin(), set.end(), l)) continue;
      DeviationSet more = set;
      more.push_back(l);
      if (!exchanging && more.size() <= most_) consider(more);
      // Exchanges are many: only where nothing else helps.
      if (exchanging)
        for (const int deviation : set) consider(without(more, deviation));
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

double DeviationSearch::deviance_and_price(const DeviationSet& set) const {
  const double gained = drop(m_, set);
  if (gained < 0.0) return std::numeric_limits<double>::infinity();
  double sum = m_.base - gained;
  for (const int deviation : set) sum += price_[static_cast<std::size_t>(deviation)];
  return sum;
}

double p_value(const DeviationMoments& m, const DeviationSet& set, int deviation,
               double statistic) {
  if (m.surrogates.size() == 0) return 1.0;
  const NullDistribution null(drops_by_chance(m, set) -
                              drops_by_chance(m, without(set, deviation)));
  const double single = std::exp(-null.surprise(statistic));
  return std::min(1.0, single * static_cast<double>(m.first.size() - 1));
}

std::optional<int> cancelled(const DeviationMoments& m, const DeviationSet& set) {
  constexpr double kMost = 25.0;  // times the energy of all together
  const std::vector<Index> at = indices(m, set);
  if (at.empty()) return std::nullopt;
  const MatrixXd gram = m.gram(at, at);
  const VectorXd value = scaled_pseudo_inverse(gram, 1e-8) * VectorXd(m.target(at));
  double largest = kMost * value.dot(gram * value);
  std::optional<int> found;
  Index first = 0;
  for (const int deviation : set) {
    const Index wide = static_cast<Index>(indices(m, {deviation}).size());
    const VectorXd own = value.segment(first, wide);
    const double energy = own.dot(gram.block(first, first, wide, wide) * own);
    first += wide;
    if (energy <= largest) continue;
    largest = energy;
    found = deviation;
  }
  return found;
}

}  // namespace sinew::diagnosis

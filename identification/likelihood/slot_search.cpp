// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_search.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/body_limits.h"
#include "identification/regression/inner_loop.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNever = -std::numeric_limits<double>::infinity();

// Sizes of slots whose entries were exchanged settle within a few sweeps.
constexpr int kMostSweeps = 4;

// A wrong side of a limit is forgiven by chance only.
constexpr double kStandardErrors = 2.0;

constexpr std::size_t kRivals = 6;

Slots without(Slots slots, std::size_t at) {
  slots.entries.erase(slots.entries.begin() + static_cast<std::ptrdiff_t>(at));
  slots.variances.erase(slots.variances.begin() + static_cast<std::ptrdiff_t>(at));
  return slots;
}

Slots with(Slots slots, int entry, double variance) {
  slots.entries.push_back(entry);
  slots.variances.push_back(variance);
  return slots;
}

double log_sum(double a, double b) {
  const double high = std::max(a, b);
  return high == kNever ? kNever : high + std::log(std::exp(a - high) + std::exp(b - high));
}

}  // namespace

/// The model with some entries.
struct SlotSearch::Posterior {
  std::vector<Index> columns;  ///< the entries'
  VectorXd precision;          ///< prior precision of the model's coefficients
  MatrixXd lower;              ///< of the posterior precision of the model's coefficients
  MatrixXd inverse;            ///< their posterior covariance
  VectorXd coefficients;
};

/// What the model with some entries leaves to a region's columns.
struct SlotSearch::Fit : Posterior {
  int region = Regions::kEverywhere;
  MatrixXd taken;   ///< its transpose times it: what the model takes of the columns' Gram matrix
  VectorXd target;  ///< products of the columns with what is left over
};

SlotSearch::SlotSearch(const Hypotheses& all, const SmallErrors& errors, int most,
                       const std::vector<bool>& banned)
    : all_(all),
      errors_(errors),
      most_(static_cast<std::size_t>(most)),
      entries_(make_entries(all, errors, banned)) {
  for (const Entry& e : entries_) regions_.push_back(errors.moments().regions().of(e.columns));
}

const Hypothesis& SlotSearch::hypothesis_of(int entry) const {
  return all_.list[static_cast<std::size_t>(entries_[static_cast<std::size_t>(entry)].hypothesis)];
}

/// Whether one of a region's columns can meet the entry's.
bool SlotSearch::meets(int entry, int region) const {
  return region == Regions::kEverywhere || region_of(entry) == Regions::kEverywhere ||
         region_of(entry) == region;
}

/// Prior precision of the entries' columns: one over each slot's variance.
VectorXd SlotSearch::precisions(const Slots& slots) const {
  std::vector<double> list;
  for (std::size_t i = 0; i < slots.entries.size(); ++i)
    list.insert(list.end(), entries_[static_cast<std::size_t>(slots.entries[i])].columns.size(),
                1.0 / slots.variances[i]);
  return VectorXd::Map(list.data(), static_cast<Index>(list.size()));
}

SlotSearch::Posterior SlotSearch::posterior(const Slots& slots) const {
  Posterior p;
  for (const int e : slots.entries) {
    const auto& own = entries_[static_cast<std::size_t>(e)].columns;
    p.columns.insert(p.columns.end(), own.begin(), own.end());
  }
  p.precision = precisions(slots);
  MatrixXd gram = errors_.gram(p.columns, p.columns);
  gram.diagonal() += p.precision;
  const Eigen::LLT<MatrixXd> factor(gram);
  p.lower = factor.matrixL();
  p.inverse = factor.solve(MatrixXd::Identity(gram.rows(), gram.cols()));
  p.coefficients = p.inverse * VectorXd(errors_.target()(p.columns));
  return p;
}

SlotSearch::Fit SlotSearch::fit(const Slots& slots, int region) const {
  const std::vector<Index>& columns = errors_.moments().regions().columns(region);
  Fit f{posterior(slots), region, {}, errors_.target()(columns)};
  if (f.columns.empty()) return f;
  const MatrixXd cross = errors_.gram(columns, f.columns);
  f.target -= cross * f.coefficients;
  f.taken = f.lower.triangularView<Eigen::Lower>().solve(MatrixXd(cross.transpose()));
  return f;
}

/// An entry given the model, which is fitted in a region that the entry meets.
ConditionalMoments SlotSearch::conditional(int entry, const Fit& given) const {
  const Entry& e = entries_[static_cast<std::size_t>(entry)];
  const std::vector<Index> at = errors_.moments().regions().places(given.region, e.columns);
  ConditionalMoments m = e.alone;
  m.target = given.target(at);
  if (!given.columns.empty())
    m.gram -= given.taken(Eigen::all, at).transpose() * given.taken(Eigen::all, at);
  return m;
}

BayesFactor SlotSearch::factor(int entry, const Fit& given) const {
  const Entry& e = entries_[static_cast<std::size_t>(entry)];
  const ConditionalMoments m = conditional(entry, given);
  // What the model spans already has nothing to say for itself.
  constexpr double kExcited = 1e-5;
  if (m.gram.diagonal().maxCoeff() < kExcited * e.alone.gram.diagonal().maxCoeff())
    return {kNever, 0.0};
  // How improbable the improbable is nobody asks: a bound is enough.
  constexpr double negligible = -20.0;
  const double most = most_by_fit(m);
  if (most + e.log_prior < negligible) return {most, kSmallestSize * kSmallestSize};
  return bayes_factor_of(m);
}

/// Of the entries whose columns a fit's region has.
std::vector<double> SlotSearch::log_odds(const Slots& given, const Fit& f) const {
  std::vector<bool> taken(all_.list.size(), false);
  for (const int g : given.entries) {
    const Candidate& held = *hypothesis_of(g).source;
    // One cause is named once, whatever its forms.
    for (std::size_t h = 0; h < all_.list.size(); ++h)
      if (all_.list[h].source->name == held.name && all_.list[h].source->place == held.place)
        taken[h] = true;
  }
  std::vector<double> odds(entries_.size(), kNever);
  inner_loop(entries_.size(), [&](std::size_t i) {
    const Entry& e = entries_[i];
    const auto h = static_cast<std::size_t>(e.hypothesis);
    if (!taken[h] && meets(static_cast<int>(i), f.region) && (all_.list[h].named || !names_alone_))
      odds[i] = factor(static_cast<int>(i), f).logarithm + e.log_prior;
  });
  return odds;
}

bool SlotSearch::is_possible(int entry, const VectorXd& coefficients,
                             const VectorXd& errors) const {
  const Entry& e = entries_[static_cast<std::size_t>(entry)];
  for (Index c = 0; c < coefficients.size(); ++c)
    if (coefficients(c) < e.alone.low(c) - kStandardErrors * errors(c) ||
        coefficients(c) > e.alone.high(c) + kStandardErrors * errors(c))
      return false;
  // Between two shapes lies one only where both act the same way.
  if (e.shapes.size() > 1) return coefficients(0) * coefficients(1) >= 0.0;
  const std::optional<double>& body_within = hypothesis_of(entry).body_within;
  const Candidate& source = *hypothesis_of(entry).source;
  if (!body_within && !source.possible) return true;
  const Moments& m = errors_.moments();
  VectorXd own = VectorXd::Zero(static_cast<Index>(source.linear.size())), spread = own;
  for (std::size_t c = 0; c < e.columns.size(); ++c) {
    const Index column = e.columns[c];
    const Index at = m.coefficient[static_cast<std::size_t>(column)];
    if (at >= own.size()) return true;  // a nuisance per log
    own(at) = m.scale(column) * coefficients(static_cast<Index>(c));
    spread(at) = m.scale(column) * errors(static_cast<Index>(c));
  }
  if (body_within && !is_body(own, spread, *body_within)) return false;
  return !source.possible ||
         source.possible(own, all_.shapes[static_cast<std::size_t>(e.shapes.front())].nonlinear);
}

bool SlotSearch::is_possible(const std::vector<int>& entries, const VectorXd& coefficients,
                             const VectorXd& variances) const {
  const VectorXd errors = variances.cwiseMax(0.0).cwiseSqrt();
  Index first = 0;
  for (const int e : entries) {
    const auto wide = static_cast<Index>(entries_[static_cast<std::size_t>(e)].columns.size());
    if (!is_possible(e, coefficients.segment(first, wide), errors.segment(first, wide)))
      return false;
    first += wide;
  }
  return true;
}

bool SlotSearch::is_possible(const Slots& slots) const {
  const Posterior f = posterior(slots);
  return is_possible(slots.entries, f.coefficients, f.inverse.diagonal());
}

/// Whether the slots, whose fit that is, are within their limits with one more entry: what it
/// changes of their coefficients, by blocks of the inverse.
bool SlotSearch::stays_possible(const Slots& given, const Fit& f, int entry,
                                double variance) const {
  ConditionalMoments m = conditional(entry, f);
  m.gram.diagonal().array() += 1.0 / variance;
  const Eigen::LLT<MatrixXd> factor(m.gram);
  const VectorXd own = factor.solve(m.target);
  const VectorXd own_variance = factor.solve(MatrixXd::Identity(own.size(), own.size())).diagonal();
  if (!is_possible(entry, own, own_variance.cwiseSqrt())) return false;
  if (given.entries.empty()) return true;
  const std::vector<Index> at = errors_.moments().regions().places(
      f.region, entries_[static_cast<std::size_t>(entry)].columns);
  // What of the model's coefficients one of the entry's takes.
  const MatrixXd taken =
      f.lower.triangularView<Eigen::Lower>().transpose().solve(MatrixXd(f.taken(Eigen::all, at)));
  const VectorXd more =
      taken.cwiseProduct(factor.solve(taken.transpose()).transpose()).rowwise().sum();
  return is_possible(given.entries, f.coefficients - taken * own, f.inverse.diagonal() + more);
}

/// The slots, whose fit that is, with one more entry, of the size that the data make most probable
/// for it.
Slots SlotSearch::sized(const Slots& given, const Fit& f, int entry) const {
  return with(given, entry, factor(entry, f).variance);
}

/// With the entry of the largest odds above 0 that leaves every slot within its limits.
std::optional<Slots> SlotSearch::with_best(const Slots& given, int region) const {
  constexpr std::size_t most_tried = 40;
  const Fit f = fit(given, region);
  const std::vector<double> odds = log_odds(given, f);
  std::vector<int> order;
  for (std::size_t e = 0; e < odds.size(); ++e)
    if (odds[e] > 0.0) order.push_back(static_cast<int>(e));
  const auto by_odds = [&](int a, int b) {
    return odds[static_cast<std::size_t>(a)] > odds[static_cast<std::size_t>(b)];
  };
  const std::size_t count = std::min(most_tried, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    by_odds);
  for (std::size_t k = 0; k < count; ++k) {
    Slots more = sized(given, f, order[k]);
    if (stays_possible(given, f, order[k], more.variances.back())) return more;
  }
  return std::nullopt;
}

/// Every slot of a region, or all, given the others: its best rival where it acts, or nothing.
/// False: nothing has changed.
bool SlotSearch::polish(Slots& slots, int region) const {
  constexpr double same = 1e-6;  // of a variance: it is one of a few sizes
  bool changed = false;
  for (std::size_t i = 0; i < slots.entries.size();) {
    if (region != Regions::kEverywhere && region_of(slots.entries[i]) != region) {
      ++i;
      continue;
    }
    Slots others = without(slots, i);
    const std::optional<Slots> best = with_best(others, region_of(slots.entries[i]));
    if (!best) {
      slots = std::move(others);
      changed = true;
      continue;
    }
    changed |= best->entries.back() != slots.entries[i] ||
               std::abs(best->variances.back() / slots.variances[i] - 1.0) > same;
    slots.entries[i] = best->entries.back();
    slots.variances[i] = best->variances.back();
    ++i;
  }
  return changed;
}

/// log posterior odds of the slots together against none.
Slots SlotSearch::weighed(Slots slots) const {
  slots.log_posterior = 0.0;
  if (slots.entries.empty()) return slots;
  for (const int e : slots.entries)
    slots.log_posterior += entries_[static_cast<std::size_t>(e)].log_prior;
  const Posterior whole = posterior(slots);
  const VectorXd size = whole.precision.cwiseInverse().cwiseSqrt();
  MatrixXd inner =
      size.asDiagonal() * errors_.gram(whole.columns, whole.columns) * size.asDiagonal();
  inner.diagonal().array() += 1.0;
  const Eigen::LLT<MatrixXd> factor(inner);
  const VectorXd own = factor.matrixL().solve(
      VectorXd(size.cwiseProduct(VectorXd(errors_.target()(whole.columns)))));
  slots.log_posterior +=
      0.5 * own.squaredNorm() - MatrixXd(factor.matrixL()).diagonal().array().log().sum();
  return slots;
}

void SlotSearch::settle(Slots& slots, int region) const {
  for (int sweep = 0; sweep < kMostSweeps && polish(slots, region); ++sweep) {
  }
}

/// By a region's entries. Slots that meet none of what was added stay as they are, and those that
/// act everywhere wait until all regions are settled.
Slots SlotSearch::grown(Slots slots, int region) const {
  while (slots.entries.size() < most_) {
    std::optional<Slots> more = with_best(slots, region);
    if (!more) break;
    settle(*more, region_of(more->entries.back()));
    const bool larger = more->entries.size() > slots.entries.size();
    slots = std::move(*more);
    if (!larger) break;
  }
  return weighed(std::move(slots));
}

/// Every value of the model's own that has one parameter.
Slots SlotSearch::own_values() const {
  Slots slots;
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const Hypothesis& h = all_.list[static_cast<std::size_t>(entries_[e].hypothesis)];
    if (h.candidate >= 0 || entries_[e].columns.size() != 1) continue;
    slots =
        with(std::move(slots), static_cast<int>(e), bayes_factor_of(entries_[e].alone).variance);
  }
  return slots;
}

Slots SlotSearch::find(Slots from) const {
  settle(from, Regions::kEverywhere);
  Slots found = grown(std::move(from), Regions::kEverywhere);
  if (errors_.moments().regions().count() == 1) return found;
  settle(found, Regions::kEverywhere);
  return weighed(std::move(found));
}

Slots SlotSearch::find() const {
  const Slots from_nothing = find({});
  const Slots from_own = find(own_values());
  const bool own_are_better = from_own.entries.size() <= most_ && is_possible(from_own) &&
                              from_own.log_posterior > from_nothing.log_posterior + 1e-6;
  return own_are_better ? from_own : from_nothing;
}

/// Beginnings of other searches: the best rivals of a region's slots in their place. Structure
/// without a name hides the names that it explains as well: its best rivals with a name begin one
/// each, too.
std::vector<Slots> SlotSearch::other_starts(const Slots& found, int region) const {
  std::vector<Slots> starts;
  for (std::size_t i = 0; i < found.entries.size(); ++i) {
    if (region_of(found.entries[i]) != region) continue;
    const Slots others = without(found, i);
    const Fit f = fit(others, region);
    const bool hides = !hypothesis_of(found.entries[i]).named;
    std::size_t tried = 0, names = 0;
    const std::vector<Rival> list = rivals(found, i);
    for (const Rival& rival : list) {
      // Of two that together say what one says, one says half of it.
      if (rival.log_odds <= 0.5 * list.front().log_odds) break;
      if (rival.hypothesis == entries_[static_cast<std::size_t>(found.entries[i])].hypothesis)
        continue;
      const bool is_name = hides && hypothesis_of(rival.entry).named;
      if (tried >= kRivals && !(is_name && names < kRivals)) continue;
      ++tried;
      names += is_name ? 1 : 0;
      starts.push_back(sized(others, f, rival.entry));
    }
  }
  return starts;
}

Slots SlotSearch::from_rivals(const Slots& found, int region) const {
  const std::vector<Slots> starts = other_starts(found, region);
  std::vector<Slots> ends(starts.size());
  tbb::parallel_for(0, static_cast<int>(starts.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    ends[k] = is_possible(starts[k]) ? grown(starts[k], region) : Slots{};
  });
  Slots best = found;
  for (const Slots& end : ends)
    if (end.log_posterior > best.log_posterior + 1e-6) best = end;
  return best;
}

Slots SlotSearch::from_rivals(const Slots& found) const {
  std::set<int> regions;
  for (const int e : found.entries) regions.insert(region_of(e));
  Slots best = found;
  for (const int region : regions) best = from_rivals(best, region);
  return best;
}

std::vector<Rival> SlotSearch::ranked(const std::vector<double>& odds) const {
  std::vector<Rival> list(all_.list.size());
  for (std::size_t h = 0; h < list.size(); ++h) list[h] = {static_cast<int>(h), -1, kNever, 0.0};
  for (std::size_t e = 0; e < odds.size(); ++e) {
    Rival& rival = list[static_cast<std::size_t>(entries_[e].hypothesis)];
    if (odds[e] == kNever) continue;
    if (rival.entry < 0 || odds[e] > odds[static_cast<std::size_t>(rival.entry)])
      rival.entry = static_cast<int>(e);
    rival.log_odds = log_sum(rival.log_odds, odds[e]);
  }
  std::erase_if(list, [](const Rival& r) { return r.entry < 0; });
  std::stable_sort(list.begin(), list.end(),
                   [](const Rival& a, const Rival& b) { return a.log_odds > b.log_odds; });
  double total = 0.0;  // nothing has odds of 1
  for (const Rival& r : list) total = log_sum(total, r.log_odds);
  for (Rival& r : list) r.probability = std::exp(r.log_odds - total);
  return list;
}

std::vector<Rival> SlotSearch::rivals(const Slots& slots, std::size_t slot) const {
  const Slots others = without(slots, slot);
  const Fit f = fit(others, region_of(slots.entries[slot]));
  std::vector<double> odds = log_odds(others, f);
  inner_loop(odds.size(), [&](std::size_t i) {
    const auto e = static_cast<int>(i);
    // What nothing is more probable than needs no look at its limits.
    if (odds[i] > 0.0 && !stays_possible(others, f, e, factor(e, f).variance)) odds[i] = kNever;
  });
  return ranked(odds);
}

std::vector<Rival> SlotSearch::credible(const Slots& slots, std::size_t slot) const {
  std::vector<Rival> list = rivals(slots, slot);
  double sum = 0.0;
  std::size_t count = 0;
  while (count < list.size() && sum < kCredible && list[count].log_odds > 0.0)
    sum += list[count++].probability;
  if (sum < kCredible) return {};
  // What lacks no more than the best one's own form may be off by is not ruled out either. A value
  // of the model's own has the model's form.
  const Hypothesis& best = all_.list[static_cast<std::size_t>(list.front().hypothesis)];
  const double off = best.candidate >= 0 ? kFormError * kFormError : 0.0;
  const double as_good = (1.0 - off) * list.front().log_odds;
  while (count < list.size() && list[count].log_odds >= as_good) ++count;
  list.resize(count);
  return list;
}

bool SlotSearch::are_named(const Slots& slots) const {
  return std::all_of(slots.entries.begin(), slots.entries.end(),
                     [&](int e) { return hypothesis_of(e).named; });
}

Slots SlotSearch::with_names(Slots slots) const {
  const auto is_named = [&](int hypothesis) {
    return all_.list[static_cast<std::size_t>(hypothesis)].named;
  };
  for (std::size_t i = 0; i < slots.entries.size(); ++i) {
    const std::vector<Rival> set = credible(slots, i);
    const auto named = std::find_if(set.begin(), set.end(),
                                    [&](const Rival& r) { return is_named(r.hypothesis); });
    if (named == set.end() || named->entry == slots.entries[i]) continue;
    const Fit f = fit(without(slots, i), region_of(slots.entries[i]));
    slots.variances[i] = factor(named->entry, f).variance;
    slots.entries[i] = named->entry;
  }
  return weighed(std::move(slots));
}

std::vector<Rival> SlotSearch::on_top(const Slots& slots) const {
  return ranked(log_odds(slots, fit(slots, Regions::kEverywhere)));
}

VectorXd SlotSearch::coefficients(const Slots& slots, std::size_t slot) const {
  const Posterior f = posterior(slots);
  Index first = 0;
  for (std::size_t i = 0; i < slot; ++i)
    first +=
        static_cast<Index>(entries_[static_cast<std::size_t>(slots.entries[i])].columns.size());
  const Entry& e = entries_[static_cast<std::size_t>(slots.entries[slot])];
  VectorXd own = f.coefficients.segment(first, static_cast<Index>(e.columns.size()));
  for (Index c = 0; c < own.size(); ++c)
    own(c) *= errors_.moments().scale(e.columns[static_cast<std::size_t>(c)]);
  return own;
}

}  // namespace sinew::diagnosis

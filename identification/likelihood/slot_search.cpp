// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>

#include "identification/likelihood/decision_constants.h"
#include "identification/regression/inner_loop.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Sizes of slots whose entries were exchanged settle within a few sweeps.
constexpr int kMostSweeps = 4;

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

bool have_same_entries(const Slots& a, const Slots& b) {
  std::vector<int> x = a.entries, y = b.entries;
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  return x == y;
}

double log_sum(double a, double b) {
  const double high = std::max(a, b);
  return high == kNoOdds ? kNoOdds : high + std::log(std::exp(a - high) + std::exp(b - high));
}

}  // namespace

SlotSearch::SlotSearch(const Hypotheses& all, const SmallErrors& errors, int most,
                       const std::vector<bool>& banned)
    : all_(all), most_(static_cast<std::size_t>(most)), model_(all, errors, banned) {}

/// The entry of the largest odds above 0, in its most probable size, that leaves every slot within
/// its limits. Odds are worked out as long as one of those left could have larger ones.
std::optional<SlotSearch::Sized> SlotSearch::best(const SlotModel::Fit& f) const {
  constexpr int most_tried = 40;
  struct Known : EntryOdds {
    double variance;
    bool operator<(const Known& other) const {
      return log_odds != other.log_odds ? log_odds < other.log_odds : entry > other.entry;
    }
  };
  const std::vector<EntryOdds> bounds = model_.odds_at_most(f, names_alone_);
  std::priority_queue<Known> known;
  auto next = bounds.begin();
  for (int tried = 0; tried < most_tried; ++tried) {
    for (; next != bounds.end() && (known.empty() || next->log_odds >= known.top().log_odds);
         ++next) {
      const BayesFactor factor = model_.factor(next->entry, f);
      const double odds = factor.logarithm + log_prior(next->entry);
      if (odds > 0.0) known.push({{next->entry, odds}, factor.variance});
    }
    if (known.empty()) return std::nullopt;
    const Known most = known.top();
    known.pop();
    if (model_.stays_possible(f, most.entry, most.variance))
      return Sized{most.entry, most.variance};
  }
  return std::nullopt;
}

/// Every slot of a region, or all, given the others: its best rival, which comes last then, or
/// nothing. False: nothing has changed.
bool SlotSearch::polish(FittedSlots& fitted, int region) const {
  constexpr double same = 1e-6;  // of a variance: it is one of a few sizes
  bool changed = false;
  std::size_t at = 0;
  for (std::size_t left = fitted.slots().entries.size(); left > 0; --left) {
    const int entry = fitted.slots().entries[at];
    const double variance = fitted.slots().variances[at];
    const int own = model_.region_of(entry);
    if (region != Regions::kEverywhere && own != region) {
      ++at;
      continue;
    }
    SlotModel::Fit others = model_.fit_without(fitted.in(own), at);
    const std::optional<Sized> rival = best(others);
    if (rival && rival->entry == entry && std::abs(rival->variance / variance - 1.0) <= same) {
      ++at;
      continue;
    }
    changed = true;
    fitted.remove(at, std::move(others));
    if (rival) fitted.add(rival->entry, rival->variance);
  }
  return changed;
}

void SlotSearch::settle(FittedSlots& fitted, int region, const Slots* known) const {
  for (int sweep = 0; sweep < kMostSweeps && polish(fitted, region); ++sweep)
    if (known && have_same_entries(fitted.slots(), *known)) return;
}

/// By a region's entries. Slots that meet none of what was added stay as they are, and those that
/// act everywhere wait until all regions are settled.
Slots SlotSearch::grown(FittedSlots& fitted, int region, const Slots* known) const {
  while (fitted.slots().entries.size() < most_) {
    const std::size_t before = fitted.slots().entries.size();
    const std::optional<Sized> more = best(fitted.in(region));
    if (!more) break;
    fitted.add(more->entry, more->variance);
    settle(fitted, model_.region_of(more->entry), known);
    if (known && have_same_entries(fitted.slots(), *known)) return *known;
    if (fitted.slots().entries.size() <= before) break;
  }
  return model_.weighed(fitted.slots());
}

Slots SlotSearch::with_own_values(Slots slots, std::optional<int> region) const {
  for (std::size_t e = 0; e < model_.entries().size(); ++e) {
    const auto entry = static_cast<int>(e);
    const Hypothesis& h = model_.hypothesis_of(entry);
    if (h.candidate >= 0 || model_.entries()[e].columns.size() != 1) continue;
    if (region && model_.region_of(entry) != *region) continue;
    slots = with(std::move(slots), entry, bayes_factor_of(model_.entries()[e].alone).variance);
  }
  return slots;
}

Slots SlotSearch::find(Slots from) const {
  FittedSlots fitted(model_, std::move(from));
  settle(fitted, Regions::kEverywhere);
  Slots found = grown(fitted, Regions::kEverywhere);
  if (model_.regions() == 1) return found;
  settle(fitted, Regions::kEverywhere);
  return model_.weighed(fitted.slots());
}

Slots SlotSearch::find() const {
  const Slots from_nothing = find({});
  const Slots from_own = find(with_own_values({}, std::nullopt));
  const bool own_are_better = from_own.entries.size() <= most_ && model_.is_possible(from_own) &&
                              from_own.log_posterior > from_nothing.log_posterior + 1e-6;
  return own_are_better ? from_own : from_nothing;
}

/// The model's own values in the place of all of a region's slots.
FittedSlots SlotSearch::own_values_instead(const Slots& found, int region) const {
  Slots elsewhere = found;
  for (std::size_t i = found.entries.size(); i-- > 0;)
    if (model_.region_of(found.entries[i]) == region) elsewhere = without(std::move(elsewhere), i);
  FittedSlots own(model_, with_own_values(std::move(elsewhere), region));
  settle(own, region);
  return own;
}

/// Beginnings of other searches: the best rivals of each slot in its place. Structure without a
/// name hides the names that it explains as well: its best rivals with a name begin one each, too.
std::vector<SlotSearch::Start> SlotSearch::other_starts(const Slots& found, int region) const {
  std::vector<Start> starts;
  const SlotModel::Fit whole = model_.fit(found, region);
  for (std::size_t i = 0; i < found.entries.size(); ++i) {
    if (model_.region_of(found.entries[i]) != region) continue;
    const auto f = std::make_shared<const SlotModel::Fit>(model_.fit_without(whole, i));
    const bool hides = !model_.hypothesis_of(found.entries[i]).named;
    std::size_t tried = 0, names = 0;
    const std::vector<Rival> list = rivals(*f);
    for (const Rival& rival : list) {
      // Of two that together say what one says, one says half of it.
      if (rival.log_odds <= 0.5 * list.front().log_odds) break;
      if (rival.hypothesis ==
          model_.entries()[static_cast<std::size_t>(found.entries[i])].hypothesis)
        continue;
      const bool is_name = hides && model_.hypothesis_of(rival.entry).named;
      if (tried >= kRivals && !(is_name && names < kRivals)) continue;
      ++tried;
      names += is_name ? 1 : 0;
      starts.push_back({f, {rival.entry, model_.factor(rival.entry, *f).variance}});
    }
  }
  return starts;
}

Slots SlotSearch::from_rivals(const Slots& found, int region) const {
  const std::vector<Start> starts = other_starts(found, region);
  std::vector<Slots> ends(starts.size() + 1);
  const auto end_of = [&](FittedSlots fitted) -> Slots {
    return model_.is_possible(fitted.slots()) ? grown(fitted, region, &found) : Slots{};
  };
  tbb::parallel_for(std::size_t{0}, ends.size(), [&](std::size_t i) {
    if (i == 0) {
      ends[i] = end_of(own_values_instead(found, region));
      return;
    }
    const Start& start = starts[i - 1];
    FittedSlots fitted(model_, *start.others);
    fitted.add(start.rival.entry, start.rival.variance);
    ends[i] = end_of(std::move(fitted));
  });
  Slots best = found;
  for (const Slots& end : ends)
    if (end.log_posterior > best.log_posterior + 1e-6) best = end;
  return best;
}

Slots SlotSearch::from_rivals(const Slots& found) const {
  std::set<int> regions;
  for (const int e : found.entries) regions.insert(model_.region_of(e));
  Slots best = found;
  for (const int region : regions) best = from_rivals(best, region);
  return best;
}

std::vector<Rival> SlotSearch::ranked(const std::vector<double>& odds) const {
  std::vector<Rival> list(all_.list.size());
  for (std::size_t h = 0; h < list.size(); ++h) list[h] = {static_cast<int>(h), -1, kNoOdds, 0.0};
  for (std::size_t e = 0; e < odds.size(); ++e) {
    Rival& rival = list[static_cast<std::size_t>(model_.entries()[e].hypothesis)];
    if (odds[e] == kNoOdds) continue;
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
  return rivals(model_.fit(without(slots, slot), model_.region_of(slots.entries[slot])));
}

std::vector<Rival> SlotSearch::rivals(const SlotModel::Fit& f) const {
  std::vector<double> odds = model_.log_odds(f, names_alone_);
  inner_loop(odds.size(), [&](std::size_t i) {
    const auto e = static_cast<int>(i);
    // What nothing is more probable than needs no look at its limits.
    if (odds[i] > 0.0 && !model_.stays_possible(f, e, model_.factor(e, f).variance))
      odds[i] = kNoOdds;
  });
  return ranked(odds);
}

/// Structure without a name follows whatever form a cause has: a law that lacks no more than its
/// form may be off by is not ruled out.
bool SlotSearch::is_as_good(const Rival& rival, const Rival& best) const {
  const auto& list = all_.list;
  const bool may_lack = !list[static_cast<std::size_t>(best.hypothesis)].named &&
                        list[static_cast<std::size_t>(rival.hypothesis)].is_law;
  return rival.log_odds >= (1.0 - (may_lack ? kFormError * kFormError : 0.0)) * best.log_odds;
}

std::vector<Rival> SlotSearch::credible(const Slots& slots, std::size_t slot) const {
  std::vector<Rival> list = rivals(slots, slot);
  double sum = 0.0;
  std::size_t count = 0;
  while (count < list.size() && sum < kCredible && list[count].log_odds > 0.0)
    sum += list[count++].probability;
  if (sum < kCredible) return {};
  const auto rest = list.begin() + static_cast<std::ptrdiff_t>(count);
  list.erase(
      std::remove_if(rest, list.end(),
                     [best = list.front(), this](const Rival& r) { return !is_as_good(r, best); }),
      list.end());
  return list;
}

double SlotSearch::may_lack(const Slots& slots) const {
  Slots exact;
  for (std::size_t i = 0; i < slots.entries.size(); ++i)
    if (!model_.hypothesis_of(slots.entries[i]).is_law)
      exact = with(std::move(exact), slots.entries[i], slots.variances[i]);
  const double of_laws = slots.log_posterior - model_.weighed(std::move(exact)).log_posterior;
  return kFormError * kFormError * std::max(0.0, of_laws);
}

bool SlotSearch::are_named(const Slots& slots) const {
  return std::all_of(slots.entries.begin(), slots.entries.end(),
                     [&](int e) { return model_.hypothesis_of(e).named; });
}

/// Of the names that the data do not tell apart, a value of the machine that the model has: it adds
/// nothing to the model. A rotor before a body's mass, which it would make impossible where it is
/// none. How a sensor reads is told where that is likeliest, and only there.
std::optional<Rival> SlotSearch::name_of(const std::vector<Rival>& set) const {
  const auto hypothesis = [&](const Rival& r) -> const Hypothesis& {
    return all_.list[static_cast<std::size_t>(r.hypothesis)];
  };
  const auto rank = [&](const Rival& r) {
    const Hypothesis& h = hypothesis(r);
    return h.candidate >= 0 || h.source->of_sensor ? 2 : h.source->of_body ? 1 : 0;
  };
  const auto likeliest =
      std::find_if(set.begin(), set.end(), [&](const Rival& r) { return hypothesis(r).named; });
  if (likeliest == set.end()) return std::nullopt;
  if (hypothesis(*likeliest).source->of_sensor) return *likeliest;
  const double least = likeliest->log_odds + std::log(1.0 - kCredible);
  Rival name = *likeliest;
  for (auto r = likeliest; r != set.end() && r->log_odds >= least; ++r)
    if (hypothesis(*r).named && rank(*r) < rank(name)) name = *r;
  return name;
}

Slots SlotSearch::with_names(Slots slots) const {
  for (std::size_t i = 0; i < slots.entries.size(); ++i) {
    const std::optional<Rival> named = name_of(credible(slots, i));
    if (!named || named->entry == slots.entries[i]) continue;
    const SlotModel::Fit f = model_.fit(without(slots, i), model_.region_of(slots.entries[i]));
    slots.variances[i] = model_.factor(named->entry, f).variance;
    slots.entries[i] = named->entry;
  }
  return model_.weighed(std::move(slots));
}

std::vector<Rival> SlotSearch::on_top(const Slots& slots) const {
  return ranked(model_.log_odds(model_.fit(slots, Regions::kEverywhere), false));
}

}  // namespace sinew::diagnosis

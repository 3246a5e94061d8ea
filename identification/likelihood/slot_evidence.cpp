// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_evidence.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "identification/likelihood/decision_constants.h"

namespace sinew::diagnosis {
namespace {

// Shares by which everything may be off: all between a simulator and a rough model.
constexpr double kShares[] = {kLeastShare, 3.2e-4, kMiddleShare, 3.2e-3, 1e-2};

/// log probability of the logs and odds of the slots under one noise and one share of small errors,
/// up to what all of them have in common.
double evidence_of(const FoundSlots& found, const SmallErrors& errors, double share,
                   const Slots& slots) {
  return log_determinant(found.whitening) + found.moments.log_free_volume +
         errors.log_likelihood() + slots.log_posterior -
         kPriceOfDecade * std::log10(share / kShares[0]);
}

struct Grower {
  const Allowed& allowed;
  FoundSlots& found;

  /// Searches one share; kept where it is the most probable so far. Its slots are where the next
  /// one begins. False: it is not the most probable.
  bool try_share(int at, Slots& slots) {
    const double share = kShares[at];
    auto errors = std::make_unique<SmallErrors>(found.moments, found.all, share, found.laws);
    auto by = std::make_unique<SlotSearch>(found.all, *errors, allowed.most, allowed.banned);
    if (slots.entries.empty()) slots = slots_of_forms(found.all, *by, found.forms);
    slots = slots.entries.empty() ? by->find() : by->find(std::move(slots));
    const double evidence = evidence_of(found, *errors, share, slots);
    if (evidence <= found.evidence) return false;
    found.evidence = evidence;
    found.small_errors = share;
    found.search = std::move(by);
    found.errors = std::move(errors);
    found.slots = slots;
    return true;
  }
};

/// Of 0, which stands for none found yet, the least one.
int place_of_share(double share) {
  return static_cast<int>(std::lower_bound(std::begin(kShares), std::end(kShares), share) -
                          std::begin(kShares));
}

}  // namespace

void grow_slots(const Allowed& allowed, FoundSlots& found) {
  constexpr int count = static_cast<int>(std::size(kShares));
  found.evidence = -std::numeric_limits<double>::infinity();
  Grower grower{allowed, found};
  Slots slots;
  if (allowed.share) {
    grower.try_share(place_of_share(*allowed.share), slots);
    return;
  }
  if (found.forms.empty()) {
    for (int at = 0; at < count; ++at) grower.try_share(at, slots);
    return;
  }
  const int known = place_of_share(found.small_errors);
  grower.try_share(known, slots);
  const Slots first = slots;
  for (int at = known + 1; at < count && grower.try_share(at, slots); ++at) {
  }
  slots = first;
  for (int at = known - 1; at >= 0 && grower.try_share(at, slots); --at) {
  }
}

namespace {

/// Whether names explain as much as structure without a name but for what their forms are off by.
bool are_as_good(const SlotSearch& search, const Slots& names, const Slots& any) {
  return names.log_posterior + search.may_lack(names) >= any.log_posterior;
}

}  // namespace

void prefer_names(FoundSlots& found) {
  SlotSearch& search = *found.search;
  search.set_names_alone(true);
  if (search.are_named(found.slots)) return;
  const Slots names = search.find();
  if (are_as_good(search, names, found.slots))
    found.slots = names;
  else
    search.set_names_alone(false);
}

bool is_more_probable(const FoundSlots& one, const FoundSlots& other) {
  const auto evidence = [](const FoundSlots& found) {
    return evidence_of(found, *found.errors, found.small_errors, found.slots);
  };
  const bool is_named = one.search->are_named(one.slots);
  if (is_named == other.search->are_named(other.slots)) return evidence(one) > evidence(other);
  return is_named ? evidence(one) + one.search->may_lack(one.slots) >= evidence(other)
                  : evidence(one) > evidence(other) + other.search->may_lack(other.slots);
}

void search_slots(const Allowed& allowed, FoundSlots& found) {
  grow_slots(allowed, found);
  const Slots grown = found.slots;
  SlotSearch& search = *found.search;
  search.set_names_alone(true);
  Slots names = search.from_rivals(search.are_named(grown) ? grown : search.find());
  search.set_names_alone(false);
  // Structure beside the names, or in their place.
  Slots any = search.find(names);
  if (grown.log_posterior > any.log_posterior) any = grown;
  if (!are_as_good(search, names, any)) any = search.from_rivals(any);
  const bool named = are_as_good(search, names, any);
  search.set_names_alone(named);
  found.slots = search.with_names(named ? std::move(names) : std::move(any));
}

}  // namespace sinew::diagnosis

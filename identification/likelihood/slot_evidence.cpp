// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_evidence.h"

#include <cmath>
#include <limits>
#include <utility>

#include "identification/likelihood/decision_constants.h"

namespace sinew::diagnosis {
namespace {

// Shares by which everything may be off. Four decades are all between a simulator and a rough
// model.
constexpr double kShares[] = {1e-4, 3.2e-4, 1e-3, 3.2e-3, 1e-2};

/// log probability of the logs and odds of the slots under one noise and one share of small errors,
/// up to what all of them have in common.
double evidence_of(const FoundSlots& found, const SmallErrors& errors, double share,
                   const Slots& slots) {
  return log_determinant(found.whitening) + found.moments.log_free_volume +
         errors.log_likelihood() + slots.log_posterior -
         kPriceOfDecade * std::log10(share / kShares[0]);
}

/// Slots with names alone, where they explain as much but for what their forms are off by; the
/// search knows of nothing else then.
Slots named_if_as_good(SlotSearch& search, Slots best) {
  search.set_names_alone(true);
  if (search.are_named(best)) return best;
  Slots named = search.from_rivals(search.find());
  if (named.log_posterior >= (1.0 - kFormError * kFormError) * best.log_posterior) return named;
  search.set_names_alone(false);
  return best;
}

}  // namespace

void grow_slots(int most, const std::vector<bool>& banned, FoundSlots& found) {
  found.evidence = -std::numeric_limits<double>::infinity();
  Slots slots;
  for (const double share : kShares) {
    auto errors = std::make_unique<SmallErrors>(found.moments, found.all, share);
    auto by = std::make_unique<SlotSearch>(found.all, *errors, most, banned);
    slots = share == kShares[0] ? by->find() : by->find(std::move(slots));
    const double evidence = evidence_of(found, *errors, share, slots);
    if (evidence <= found.evidence) continue;
    found.evidence = evidence;
    found.small_errors = share;
    found.search = std::move(by);
    found.errors = std::move(errors);
    found.slots = slots;
  }
}

void search_slots(int most, const std::vector<bool>& banned, FoundSlots& found) {
  grow_slots(most, banned, found);
  found.slots = found.search->from_rivals(found.slots);
  found.slots = named_if_as_good(*found.search, std::move(found.slots));
  found.slots = found.search->with_names(found.slots);
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/likelihood/slot_verdict.h"

#include <algorithm>

#include "identification/diagnosis/confidence.h"

namespace sinew::diagnosis {
namespace {

RankedCause ranked(const FoundSlots& found, const Rival& rival, double best) {
  const Hypothesis& h = found.all.list[static_cast<std::size_t>(rival.hypothesis)];
  RankedCause cause;
  cause.candidate = h.candidate;
  cause.name = h.source->name;
  cause.place = h.source->place;
  cause.behind = best - rival.log_odds;
  cause.weight = rival.probability;
  return cause;
}

/// The named members of a slot's credible set, what the model is extended by first. Structure
/// without a name of which a member's form is a part does not speak against it.
NamedCause name_slot(const FoundSlots& found, std::size_t slot) {
  NamedCause cause;
  cause.candidate = hypothesis_of(found, slot).candidate;
  if (!hypothesis_of(found, slot).named) return cause;
  double named = 0.0;
  const std::vector<Rival> set = found.search->credible(found.slots, slot);
  for (const Rival& rival : set) {
    const Hypothesis& h = found.all.list[static_cast<std::size_t>(rival.hypothesis)];
    if (!h.named) continue;
    if (cause.members.empty()) cause.log_odds = rival.log_odds;
    named += rival.probability;
    cause.members.push_back(ranked(found, rival, set.front().log_odds));
  }
  const auto adopted =
      std::find_if(cause.members.begin(), cause.members.end(),
                   [&](const RankedCause& m) { return m.candidate == cause.candidate; });
  if (adopted != cause.members.end()) std::rotate(cause.members.begin(), adopted, adopted + 1);
  cause.confidence = kHighestConfidence * std::min(1.0, named);
  return cause;
}

}  // namespace

const Hypothesis& hypothesis_of(const FoundSlots& found, std::size_t slot) {
  return found.all.list[static_cast<std::size_t>(
      found.search->entries()[static_cast<std::size_t>(found.slots.entries[slot])].hypothesis)];
}

bool is_told(const FoundSlots& found, std::size_t slot) {
  return !found.search->credible(found.slots, slot).empty();
}

void tell_unnamed(const FoundSlots& found, Unexplained& said) {
  double named = 0.0, all = 0.0;
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) {
    const std::vector<Rival> set = found.search->credible(found.slots, i);
    if (set.empty()) continue;
    const Hypothesis& h = hypothesis_of(found, i);
    all += set.front().log_odds;
    if (h.named) {
      named += set.front().log_odds;
      continue;
    }
    said.none_of_the_known = true;
    said.depends_on.push_back({h.source->depends_on.empty() ? h.source->name : h.source->depends_on,
                               h.source->place, set.front().log_odds});
  }
  said.named_share = all > 0.0 ? named / all : 1.0;
}

std::vector<NamedCause> name_slots(const FoundSlots& found) {
  std::vector<NamedCause> list;
  for (std::size_t i = 0; i < found.slots.entries.size(); ++i) list.push_back(name_slot(found, i));
  return list;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// Fits that follow slots that come and go are those that would be made from nothing.
#include "identification/likelihood/fitted_slots.h"

#include <catch2/catch.hpp>

#include "tests/identification/likelihood/random_moments.h"

namespace {

using namespace sinew::diagnosis;

/// Of each joint, and of both.
void check_all(const SlotModel& model, FittedSlots& fitted) {
  for (int region = Regions::kEverywhere; region < model.regions(); ++region) {
    CAPTURE(region, fitted.slots().entries);
    check_same(model, fitted.in(region), model.fit(fitted.slots(), region));
  }
}

/// The entry of a hypothesis that stands first.
int entry_of(const SlotModel& model, int hypothesis) {
  for (std::size_t e = 0; e < model.entries().size(); ++e)
    if (model.entries()[e].hypothesis == hypothesis) return static_cast<int>(e);
  FAIL("no entry of hypothesis " << hypothesis);
  return -1;
}

}  // namespace

// Seen red where a slot of another joint was added to a joint's fit as if it were one of its own.
TEST_CASE("the fits of all joints follow a slot that comes or goes at one of them") {
  const Random random(true);
  const SmallErrors errors(random.m, random.all, 1e-3);
  const SlotModel model(random.all, errors, std::vector<bool>(6, false));
  REQUIRE(model.regions() == 2);
  const int first = entry_of(model, 0), other = entry_of(model, 2), both = entry_of(model, 4);
  REQUIRE(model.region_of(first) == 0);
  REQUIRE(model.region_of(other) == 1);
  REQUIRE(model.region_of(both) == Regions::kEverywhere);
  FittedSlots fitted(model, {{both, first}, {0.04, 0.01}, 0.0});
  check_all(model, fitted);
  fitted.add(other, 0.09);
  check_all(model, fitted);
  fitted.remove(1, model.fit_without(fitted.in(0), 1));
  check_all(model, fitted);
  fitted.add(first, 0.04);
  fitted.remove(0, model.fit_without(fitted.in(1), 0));
  fitted.add(both, 0.01);
  check_all(model, fitted);
}

// Seen red with the fit taken for one of the slots before.
TEST_CASE("slots that are fitted in one joint are fitted in all") {
  const Random random(true);
  const SmallErrors errors(random.m, random.all, 1e-3);
  const SlotModel model(random.all, errors, std::vector<bool>(6, false));
  const Slots slots{{entry_of(model, 4), entry_of(model, 1)}, {0.04, 0.01}, 0.0};
  FittedSlots fitted(model, model.fit(slots, 0));
  fitted.add(entry_of(model, 3), 0.09);
  CHECK(fitted.slots().entries.size() == 3);
  check_all(model, fitted);
}

// SPDX-License-Identifier: GPL-3.0-or-later
// What is made from another fit is the fit that would be made from nothing.
#include "identification/likelihood/slot_model.h"

#include <catch2/catch.hpp>

#include "identification/likelihood/slot_forms.h"
#include "tests/identification/likelihood/random_moments.h"

namespace {

using namespace sinew::diagnosis;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Slots without(Slots slots, std::size_t at) {
  slots.entries.erase(slots.entries.begin() + static_cast<std::ptrdiff_t>(at));
  slots.variances.erase(slots.variances.begin() + static_cast<std::ptrdiff_t>(at));
  return slots;
}

}  // namespace

// Seen red with what the slot alone takes not given back, and with its target left as it was; of
// the slot that comes back, with the model's coefficients left as they were, and with its rows not
// taken off the Gram matrices.
TEST_CASE("the fit without a slot follows from the fit with it, and the other way round") {
  const Random random;
  const SmallErrors errors(random.m, random.all, 1e-3);
  const SlotModel model(random.all, errors, std::vector<bool>(6, false));
  const Slots slots{{0, 1, 5}, {0.04, 0.01, 0.09}, 0.0};
  const SlotModel::Fit whole = model.fit(slots, Regions::kEverywhere);
  for (std::size_t slot = 0; slot < 3; ++slot) {
    CAPTURE(slot);
    const Slots others = without(slots, slot);
    const SlotModel::Fit made = model.fit_without(whole, slot);
    check_same(model, made, model.fit(others, Regions::kEverywhere));
    Slots again = others;
    again.entries.push_back(slots.entries[slot]);
    again.variances.push_back(slots.variances[slot]);
    check_same(model, model.fit_with(made, again.entries.back(), again.variances.back()),
               model.fit(again, Regions::kEverywhere));
  }
}

// Seen red with bounds of half that size, and without the entries of several columns.
TEST_CASE("log odds are no larger than their bounds, and what is above 0 has one") {
  Random random;
  for (const double target : {1.0, 0.1}) {
    random.m.target *= target;
    const SmallErrors errors(random.m, random.all, 1e-3);
    const SlotModel model(random.all, errors, std::vector<bool>(6, false));
    const Slots slots{{1}, {0.01}, 0.0};
    const SlotModel::Fit fit = model.fit(slots, Regions::kEverywhere);
    const std::vector<double> odds = model.log_odds(fit, false);
    const std::vector<EntryOdds> bounds = model.odds_at_most(fit, false);
    REQUIRE_FALSE(bounds.empty());
    std::vector<double> most(odds.size(), kNoOdds);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if (i > 0) CHECK(bounds[i].log_odds <= bounds[i - 1].log_odds);
      most[static_cast<std::size_t>(bounds[i].entry)] = bounds[i].log_odds;
    }
    for (std::size_t e = 0; e < odds.size(); ++e)
      if (odds[e] > 0.0) CHECK(odds[e] <= most[e]);
  }
}

// Seen red with the first shape of the hypothesis in place of the nearest one.
TEST_CASE("a form of another search is the nearest shape here, and none where there is none") {
  const Random random;
  const SmallErrors errors(random.m, random.all, 1e-3);
  const SlotSearch search(random.all, errors, 8, {false, false, true, false, false, false});
  const VectorXd none, near = VectorXd::Constant(1, 4.0);
  const Slots slots = slots_of_forms(random.all, search,
                                     {{9, "cause 1", "joint", near, 0.02},
                                      {2, "cause 2", "joint", none, 0.02},
                                      {3, "cause 3", "another joint", none, 0.02},
                                      {4, "cause 4", "joint", none, 0.03}});
  REQUIRE(slots.entries.size() == 2);
  const Entry& first = search.entries()[static_cast<std::size_t>(slots.entries[0])];
  CHECK(first.hypothesis == 1);
  CHECK(first.shapes == std::vector<int>{3});
  CHECK(search.entries()[static_cast<std::size_t>(slots.entries[1])].hypothesis == 4);
  CHECK(slots.variances == std::vector<double>{0.02, 0.03});
}

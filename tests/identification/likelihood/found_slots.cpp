// SPDX-License-Identifier: GPL-3.0-or-later
// What was found is off by a share of itself, and a search of names alone.
#include "identification/likelihood/found_slots.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "identification/likelihood/fitted_baseline.h"
#include "identification/likelihood/form_errors_of_found.h"
#include "identification/likelihood/slot_evidence.h"
#include "tests/identification/likelihood/drive_stretches.h"

namespace {

using namespace sinew::test;

/// The search over one simulated log of 30 s.
struct DriveSearch {
  DriveSearch(const std::string& effect, double size, unsigned seed)
      : drive(drive_stretches({effect}, {size}, 1, 30.0, seed)),
        problem(drive.problem({0})),
        design(problem, drive.settings),
        baseline(fitted_baseline(design)),
        found(find_slots(design, drive.settings, baseline, Rivals::asked, {})) {}

  bool is_named(int entry) const {
    const Entry& e = found->search->entries()[static_cast<std::size_t>(entry)];
    return found->all.list[static_cast<std::size_t>(e.hypothesis)].named;
  }

  DriveStretches drive;
  Problem problem;
  Design design;
  Model baseline;
  std::unique_ptr<FoundSlots> found;
};

}  // namespace

// Seen red with an error of 0 and with one that every row has.
TEST_CASE("rows count for less where what was found is large", "[slow]") {
  const DriveSearch s("viscous asymmetry", 20.0, 41);
  REQUIRE_FALSE(s.found->slots.entries.empty());
  const Whitening noise_alone =
      whitening_beside(s.design, s.found->model,
                       immaterial_variance(s.design, s.drive.settings, s.found->all.parts.base));
  const Eigen::VectorXd share =
      s.found->whitening.training.front().cwiseQuotient(noise_alone.training.front());
  CHECK(share.maxCoeff() <= 1.0 + 1e-9);
  // Found are a few times the motion's frequencies; towards the band's end is next to nothing.
  CHECK(share.minCoeff() < 0.5);
  CHECK(share.tail(share.size() / 5).mean() > 0.9);
}

// Seen red with an error of form for every name, and with what a law says beyond nothing.
TEST_CASE("what has the model's form is off by none, nor what the model's values can say",
          "[slow]") {
  const DriveSearch s("viscous asymmetry", 20.0, 41);
  REQUIRE_FALSE(s.found->slots.entries.empty());
  const Model& base = s.found->all.parts.base;
  const Whitening noise = whitening_beside(s.design, s.found->model,
                                           immaterial_variance(s.design, s.drive.settings, base));
  const std::size_t first = base.terms.size();
  const auto least_share = [&](const Model& found, const Model& free) {
    return with_form_errors(noise, found, first, free).noise_share.front().minCoeff();
  };
  CHECK(least_share(s.found->model, base) < 0.5);
  Model free = base;
  free.terms.insert(free.terms.end(), s.found->model.terms.begin() + static_cast<long>(first),
                    s.found->model.terms.end());
  CHECK(least_share(s.found->model, free) > 0.999);
  std::vector<Candidate> exact;
  exact.reserve(s.found->model.terms.size());
  Model mechanical = s.found->model;
  for (std::size_t t = first; t < mechanical.terms.size(); ++t) {
    exact.push_back(*mechanical.terms[t].candidate);
    exact.back().has_model_form = true;
    mechanical.terms[t].candidate = &exact.back();
  }
  const Whitening alone = with_form_errors(noise, mechanical, first, base);
  CHECK(alone.training.front() == noise.training.front());
}

// Seen red with a search that does not look at it.
TEST_CASE("a search of names alone leaves structure out, in its rivals too", "[slow]") {
  const DriveSearch s("bump in position", 2.0, 77);
  SlotSearch& search = *s.found->search;
  search.set_names_alone(false);
  const Slots all = search.from_rivals(search.find());
  CHECK(std::any_of(all.entries.begin(), all.entries.end(),
                    [&](int entry) { return !s.is_named(entry); }));
  search.set_names_alone(true);
  const Slots named = search.from_rivals(search.find());
  for (const int entry : named.entries) CHECK(s.is_named(entry));
  REQUIRE_FALSE(named.entries.empty());
  for (const Rival& rival : search.rivals(named, 0)) CHECK(s.is_named(rival.entry));
}

// Seen red with a share that is not looked at.
TEST_CASE("small errors that are held are the search's", "[slow]") {
  const DriveSearch s("viscous asymmetry", 20.0, 41);
  FoundSlots& found = *s.found;
  const double any = found.small_errors;
  for (const double share : {kMiddleShare, kLeastShare}) {
    grow_slots({3, std::vector<bool>(found.all.list.size(), false), share}, found);
    CHECK(found.small_errors == share);
  }
  grow_slots({3, std::vector<bool>(found.all.list.size(), false), {}}, found);
  CHECK(found.small_errors == any);
}

// Seen red with evidence alone, and with the names' tolerance given to structure.
TEST_CASE("of two searches' ends names may lack what their forms are off by", "[slow]") {
  const DriveSearch bump("bump in position", 2.0, 77), names("bump in position", 2.0, 77);
  search_names_alone(names.design, names.drive.settings, *names.found);
  REQUIRE_FALSE(bump.found->search->are_named(bump.found->slots));
  REQUIRE(names.found->search->are_named(names.found->slots));
  const double lack = names.found->search->may_lack(names.found->slots);
  const double less = bump.found->slots.log_posterior - names.found->slots.log_posterior;
  REQUIRE(lack > 0.0);
  CHECK(less > lack);
  CHECK(is_more_probable(*bump.found, *names.found));
  CHECK_FALSE(is_more_probable(*names.found, *bump.found));
  names.found->slots.log_posterior += less - 0.5 * lack;
  CHECK(is_more_probable(*names.found, *bump.found));
  CHECK_FALSE(is_more_probable(*bump.found, *names.found));
}

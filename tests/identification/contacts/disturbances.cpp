// SPDX-License-Identifier: GPL-3.0-or-later
// Turns by which it settles what is disturbed.
#include "identification/contacts/disturbances.h"

#include <catch2/catch.hpp>

namespace {

using namespace sinew::diagnosis;

/// A log of 100 samples of which these are disturbed.
Disturbances at(const std::vector<std::pair<Eigen::Index, Eigen::Index>>& stretches) {
  Disturbances d;
  d.left_over.resize(1);
  d.aside.push_back(SetAside::Constant(100, false));
  for (const auto& [first, last] : stretches) {
    d.aside.front().segment(first, last - first) = true;
    d.list.push_back({0, first, last});
  }
  return d;
}

const Disturbances kWide = at({{10, 20}, {40, 60}}), kNarrow = at({{40, 55}}),
                   kOther = at({{10, 20}, {70, 90}});

bool are_same(const Disturbances& a, const Disturbances& b) {
  return (a.aside.front() == b.aside.front()).all() && a.list.size() == b.list.size();
}

}  // namespace

TEST_CASE("what is found again has settled") {
  int turns = 0;
  const auto next = [&](const Disturbances&) {
    ++turns;
    return kNarrow;
  };
  CHECK(are_same(settled(kWide, next), kNarrow));
  CHECK(turns == 2);
}

// Seen red where turns were only counted: eight searches, and the eighth's end.
TEST_CASE("what turns lead around to is disturbed in all of them") {
  int turns = 0;
  const auto around = [&](const Disturbances& a, const Disturbances& b) {
    return [&](const Disturbances& known) {
      ++turns;
      return are_same(known, a) ? b : a;
    };
  };
  const Disturbances found = settled(kWide, around(kWide, kNarrow));
  CHECK(are_same(found, kNarrow));
  CHECK(turns == 2);
  turns = 0;
  CHECK(are_same(settled(kOther, around(kOther, kWide)), at({{10, 20}})));
  CHECK(turns == 2);
  turns = 0;
  CHECK(are_same(settled(kNarrow, around(kNarrow, kOther)), kOther));  // nothing is in both
}

TEST_CASE("where nothing is disturbed any more, what was known stays") {
  CHECK(are_same(settled(kWide, [](const Disturbances&) { return at({}); }), kWide));
}

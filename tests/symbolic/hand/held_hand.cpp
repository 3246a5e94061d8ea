// SPDX-License-Identifier: GPL-3.0-or-later
// The hand with its palm held, as a diagnosis looks at it.
#include <catch2/catch.hpp>

#include "symbolic/hand/hand_mechanism.h"
#include "symbolic/hand/read_hand.h"

using namespace sinew;

TEST_CASE("a held hand has every finger's coordinates, with a four-bar and without one", "[hand]") {
  // Planted defect, seen to fail: the last coordinate taken for the crank's whether there is one or
  // not.
  Hand hand = read_hand(SINEW_SOURCE_DIR "/models/hand").hand;
  const HeldHand with = held_hand(hand);
  CHECK(with.coordinates.size() + 1 == coordinate_names(hand).size());
  // The same with what rides on the linkage on the palm, and without the linkage's two tendons.
  for (HandFinger& finger : hand.fingers) finger.on_coupler = false;
  hand.wrist.forearm_points.resize(hand.wrist.forearm_points.size() - 2);
  hand.wrist.palm_points.resize(hand.wrist.palm_points.size() - 2);
  hand.four_bar_name.clear();
  hand.four_bar_channels.clear();
  const HeldHand without = held_hand(hand);
  CHECK(without.coordinates == coordinate_names(hand));
  CHECK(without.mechanism.joints.size() == with.mechanism.joints.size());
  CHECK(without.channels == with.channels);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/hand/hand_members.h"

#include <stdexcept>

#include "symbolic/expressions/argument.h"
#include "symbolic/expressions/inline_function.h"
#include "symbolic/dynamics/joint_tree.h"
#include "symbolic/dynamics/symbols.h"
#include "symbolic/tendons/tendons.h"

namespace sinew {
namespace {

/// Each channel carries one tendon.
void check_channels(const Hand& hand) {
  std::vector<int> uses(hand.wrist.forearm_points.size(), 0);
  const auto use = [&](const std::vector<int>& channels, std::size_t tendons) {
    if (channels.size() != tendons)
      throw std::invalid_argument(hand.name + ": a member has not one channel a tendon");
    for (const int channel : channels) ++uses.at(static_cast<std::size_t>(channel));
  };
  for (const HandFinger& finger : hand.fingers)
    use(finger.channels, finger.mechanism.tendons.size());
  use(hand.four_bar_channels, hand.has_four_bar() ? 2 : 0);
  for (const int count : uses)
    if (count != 1)
      throw std::invalid_argument(hand.name + ": a wrist channel has no tendon, or more than one");
}

}  // namespace

HandStart::HandStart(const Hand& of) : hand(of) {
  check_channels(hand);
  std::vector<Range> ranges;
  std::vector<double> reference;
  for (const HandFinger& finger : hand.fingers) {
    const Argument own = joint_positions(finger.mechanism);
    ranges.insert(ranges.end(), own.ranges.begin(), own.ranges.end());
    reference.insert(reference.end(), own.reference.begin(), own.reference.end());
  }
  if (hand.has_four_bar()) {
    ranges.push_back(hand.four_bar.theta2);
    reference.push_back(hand.four_bar.reference_theta2);
  }
  const int count = static_cast<int>(ranges.size());
  q = array_argument("q", count, 1, "rad", {0, 0}, "coordinates of the fingers, crank angle");
  q.ranges = ranges;
  q.reference = reference;
  q_wrist = array_argument("q_wrist", 2, 1, "rad", {0, 0}, "bar angles q71, q73");
  q_wrist.ranges = bar_ranges(hand.wrist);
  q_wrist.reference = rounded_reference(hand.wrist);
}

std::vector<GiNaC::ex> HandStart::wrist_inputs() const {
  return {q_wrist.symbols[0], q_wrist.symbols[1]};
}

std::vector<GiNaC::symbol> HandStart::member_symbols(std::size_t first, std::size_t count) const {
  const auto begin = q.symbols.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

void HandStart::add_tendons() {
  std::size_t first = 0;
  const auto add = [&](HandMember member) {
    member.P = coupling_matrix(list, member.lengths, member.q);
    first += member.q.size();
    members.push_back(std::move(member));
  };
  for (const HandFinger& finger : hand.fingers) {
    const auto count = static_cast<std::size_t>(joint_positions(finger.mechanism).rows);
    HandMember member{first, member_symbols(first, count), finger.channels, {}, {}};
    member.lengths =
        tendon_lengths(list, finger.mechanism, build_joint_tree(finger.mechanism), member.q);
    add(std::move(member));
  }
  if (!hand.has_four_bar()) return;
  HandMember crank{first, member_symbols(first, 1), hand.four_bar_channels, {}, {}};
  crank.lengths = inlined(list, four_bar_tendon_lengths(hand.four_bar), {crank.q[0]})[0];
  add(std::move(crank));
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// The tendons of fingers and four-bar within one derivation of the whole hand.
#pragma once

#include "symbolic/expressions/definition_list.h"
#include "symbolic/hand/hand.h"

namespace sinew {

/// A finger, or the four-bar, with its share of the hand's coordinates.
struct HandMember {
  std::size_t first;               ///< of its coordinates in q
  std::vector<GiNaC::symbol> q;    ///< the hand's symbols
  std::vector<int> channels;       ///< from 0
  std::vector<GiNaC::ex> lengths;  ///< without the wrist [m]
  std::vector<GiNaC::ex> P;        ///< tendons x its coordinates [m/rad]
};

/// What every function of the hand starts from.
struct HandStart {
  explicit HandStart(const Hand& hand);
  /// Derives lengths and coupling of all members.
  void add_tendons();
  std::size_t coordinates() const { return q.symbols.size(); }
  std::size_t channels() const { return hand.wrist.forearm_points.size(); }
  std::vector<GiNaC::ex> wrist_inputs() const;
  std::vector<GiNaC::symbol> member_symbols(std::size_t first, std::size_t count) const;

  const Hand& hand;
  Argument q, q_wrist;
  DefinitionList list;
  std::vector<HandMember> members;
};

}  // namespace sinew

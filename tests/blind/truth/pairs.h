// SPDX-License-Identifier: GPL-3.0-or-later
// Causes that a log cannot tell apart, since its motion was such: at one speed, in one direction,
// under one load, at one frequency.
#pragma once

#include <string>
#include <vector>

#include "tests/blind/truth/random_draw.h"
#include "tests/blind/truth/signals.h"

namespace sinew::trials {

struct PairMember {
  std::string cause;
  int sign = 0;  ///< of the dose, where the other one is not the others' (1 or -1)
};

struct Pairing {
  std::string name;
  std::vector<PairMember> members;  ///< two or three
  truth::Course course = truth::Course::mixed;
  bool loaded = false;   ///< under a load, which is the same all the time
  bool carries = false;  ///< a pendulum, in which the causes of a position act
};

/// One of those that a plant offers, of `cause` where it is named. Throws std::invalid_argument
/// where there is none.
Pairing draw_pairing(const std::string& plant, const std::string& cause, truth::Draw& draw);

}  // namespace sinew::trials

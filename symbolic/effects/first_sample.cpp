// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/first_sample.h"

namespace sinew {

GiNaC::ex first_sample(Effect& effect) {
  const GiNaC::symbol begun("begun");
  effect.states.push_back({begun, 1});
  return 1 - begun;
}

}  // namespace sinew

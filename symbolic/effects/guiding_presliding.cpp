// SPDX-License-Identifier: GPL-3.0-or-later
// Guiding friction that a log resolves: at a reversal the tendon creeps in its guide for a short
// way before it slips, and the friction builds up over that way (bristle.h).
#include "symbolic/effects/bristle.h"
#include "symbolic/effects/effects.h"

namespace sinew {

Effect guiding_presliding() {
  Effect e = guiding_friction();
  e.id = "guiding_presliding";
  creep_in_guide(e);
  e.signature =
      "a share of the tendon's force is lost, against its motion, and builds up over a short way "
      "behind every reversal";
  return e;
}

}  // namespace sinew

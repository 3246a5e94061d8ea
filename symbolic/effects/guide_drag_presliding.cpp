// SPDX-License-Identifier: GPL-3.0-or-later
// A sheath's friction that a log resolves: it builds up over a short way behind a reversal.
#include "symbolic/effects/bristle.h"
#include "symbolic/effects/effects.h"

namespace sinew {

Effect guide_drag_presliding() {
  Effect e = guide_drag();
  e.id = "guide_drag_presliding";
  creep_in_guide(e);
  e.signature =
      "a force is lost against the tendon's motion, however hard it is pulled, and builds up over "
      "a short way behind every reversal";
  return e;
}

}  // namespace sinew

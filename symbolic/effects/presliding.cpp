// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/bristle.h"
#include "symbolic/effects/effects.h"

namespace sinew {

Effect presliding() {
  Effect e("presliding", "presliding of friction");
  const GiNaC::ex length = e.shape("presliding_length", "{position}", Scale::reach, 1e-8, 1e-2, 5);
  const GiNaC::ex now = add_bristle(length, e);
  e.column("level", "{effort}", Sign::positive, now);
  e.signature = "friction that builds up over a short way behind every reversal";
  e.excitation = "small motions with reversals";
  e.experiment = "very small slow triangles";
  e.limit = "friction would drive the motion";
  e.baseline_only = true;
  return e;
}

}  // namespace sinew

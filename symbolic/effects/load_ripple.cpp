// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect load_ripple() {
  Effect e("load_ripple", "ripple proportional to load");
  const EffectSignals& s = effect_signals();
  const GiNaC::ex order = e.shape("wavenumber", "rad/{position}", Scale::none, 1.0, 1000.0);
  e.column("sine", "1", Sign::any, s.load * GiNaC::sin(order * s.position), true);
  e.column("cosine", "1", Sign::any, s.load * GiNaC::cos(order * s.position), true);
  e.signature = "a periodic effort over the position that grows with the load";
  e.excitation = "motion over several periods under different loads";
  e.experiment = "slow constant speed under several loads";
  return e;
}

}  // namespace sinew

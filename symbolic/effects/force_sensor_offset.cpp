// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/effects/effects.h"

namespace sinew {

Effect force_sensor_offset() {
  Effect e("force_sensor_offset", "offset of the force sensor");
  e.column("force_offset", "N", Sign::any, 1);
  e.signature =
      "constant torques at the joints that one tendon passes, in the ratio of its radii, "
      "and at its motor";
  e.excitation = "none";
  e.experiment = "the tendon slack: what its sensor still shows";
  e.at_tendon = true;
  e.felt_by_motor = true;
  return e;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Guiding friction where the tendon is soft between guide and finger: through the guide it goes
// with its motor, which turns round before the joints do. The velocity and direction are that of
// the motor's end of the tendon.
#include "symbolic/effects/effects.h"

namespace sinew {

Effect motor_side_guiding() {
  Effect e = guiding_friction();
  e.id = "motor_side_guiding";
  e.signature =
      "a share of the tendon's force is lost, against its motor's motion, more where it is bent";
  e.motor_side = true;
  return e;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/diagnosis/confirmation.h"

namespace sinew::diagnosis {

bool is_plain(const NamedCause& cause) {
  constexpr double kShare = 0.2, kOdds = 4.6;  // a hundred to one
  return cause.log_odds > kOdds &&
         (cause.cross_validated.low > kShare || cause.left_without > kExcess);
}

bool is_confirmed(const NamedCause& cause) {
  return is_sure(cause.confirmed) || (is_plain(cause) && cause.confirmed.share > 0.0);
}

}  // namespace sinew::diagnosis

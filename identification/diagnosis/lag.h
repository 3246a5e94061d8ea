// SPDX-License-Identifier: GPL-3.0-or-later
// A first-order lag of the position shifts the model's time as a delay does, and bends it a little.
#pragma once

#include <optional>

#include "identification/diagnosis/select.h"

namespace sinew::diagnosis {

/// How far a lag is behind the delay that stands in term `term`, as a difference of deviances: 0
/// where the logs do not tell, negative where they are bent as by a lag. Empty: no delay, or no lag
/// among the candidates.
struct LagBehind {
  int candidate = 0;  ///< the lag, index into the library
  double deviance = 0.0;
  BandColumns columns;  ///< the lag's own, at the delay's size
};
std::optional<LagBehind> lag_behind_delay(const Design& design, const Selection& state,
                                          std::size_t term);

}  // namespace sinew::diagnosis

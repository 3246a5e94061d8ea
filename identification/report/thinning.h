// SPDX-License-Identifier: GPL-3.0-or-later
// Long series made short without hiding what a person looks for.
#pragma once

#include "identification/report/findings.h"

namespace sinew::diagnosis {

/// At most about `most` samples. A line whose x never falls keeps the smallest and largest y of
/// every stretch (equal stretches of log x where `logarithmic`, where samples that have no
/// logarithm are left out); other lines and points keep every n-th sample. Deterministic. Lists of
/// unequal length are cut to the shorter one.
Series thinned(const Series& series, bool logarithmic, std::size_t most = 700);

}  // namespace sinew::diagnosis

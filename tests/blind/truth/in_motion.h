// SPDX-License-Identifier: GPL-3.0-or-later
// Which samples of a log count: at rest, and where a joint turns round, friction is whatever holds
// it. The rule is the one that docs/diagnosis_rules.md states.
#pragma once

#include <utility>
#include <vector>

#include "tests/blind/truth/hidden.h"

namespace sinew::trials {

/// First and last sample of each stretch that does not count.
using Rests = std::vector<std::pair<Index, Index>>;

/// `fast`: velocity behind the smoother of `cutoff` [Hz], whose reversals are taken out where they
/// leave enough of the log; `slow`: behind a slower one, or empty.
Rests rests_of(const VectorXd& fast, const VectorXd& slow, double step, double cutoff);

/// 1 in motion, 0 at rest, flanks of 20 ms between.
VectorXd weight_of(const Rests& rests, Index rows, double step);

}  // namespace sinew::trials

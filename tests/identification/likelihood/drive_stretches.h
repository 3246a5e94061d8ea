// SPDX-License-Identifier: GPL-3.0-or-later
// One simulated drive's long log in stretches, each of which is a log by itself.
#pragma once

#include <vector>

#include "identification/likelihood/log_sums.h"
#include "tests/identification/diagnosis/synthetic_drive.h"

namespace sinew::test {

struct DriveStretches {
  std::vector<Recording> logs;
  Settings settings;
  /// The drive's candidates, and these logs to learn from.
  Problem problem(const std::vector<std::size_t>& training) const;

  double period_in = 0.0, period_out = 0.0;
};

/// `count` logs of `duration` s each.
DriveStretches drive_stretches(const std::vector<std::string>& effects,
                               const std::vector<double>& sizes, std::size_t count, double duration,
                               unsigned seed);

}  // namespace sinew::test

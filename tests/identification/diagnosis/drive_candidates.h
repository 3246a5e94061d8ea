// SPDX-License-Identifier: GPL-3.0-or-later
// A plain candidate list for one drive, for testing the engine by itself.
#pragma once

#include <string>
#include <vector>

#include "identification/regression/candidate.h"

namespace sinew::test {

using namespace diagnosis;

/// Scales of a drive, from which starting grids and splines follow.
struct DriveScales {
  double speed = 1.0;             ///< largest |qd|
  double low = -1.0, high = 1.0;  ///< range of q
  double duration = 60.0;         ///< s
  double load = 0.0;              ///< largest |load|; 0: no load channel
  double period_in = 0.0;         ///< q for one turn of the motor; 0: unknown
  double period_out = 0.0;        ///< q for one turn of the output; 0: none
  bool revolute = false;
  double presliding = 1e-3;  ///< q over which friction builds up after a reversal
};

DriveScales drive_scales(const std::vector<Recording>& logs);

/// Inertia, viscous, Coulomb and offset.
std::vector<Candidate> drive_baseline(const DriveScales& scales);

/// Presliding length of the baseline's Coulomb friction as fitted to the logs.
double fitted_presliding(const std::vector<Recording>& logs, const DriveScales& scales,
                         const Settings& settings);

/// Named causes, decoys and flexible families.
std::vector<Candidate> drive_library(const DriveScales& scales);

}  // namespace sinew::test

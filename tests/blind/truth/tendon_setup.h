// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers and hands as they are drawn, and the files of their models.
#pragma once

#include "tests/blind/truth/jointed.h"

namespace sinew::trials {

struct TendonSetup {
  Mechanics mechanics = Mechanics::own;
  Jointed jointed;                    ///< all joints; of a hand in the palm's frame
  std::vector<std::string> channels;  ///< of the joints' positions
  std::vector<Chain> fingers;         ///< of a hand, each in its own frame; empty: a lone finger
  std::vector<Vector3d> bases;        ///< of the fingers in the palm's frame
  Rhythm rhythm;
  bool motors = false, resolved = false;
  AxisModel motor;
  Bristle motor_bristle;
  double motor_radius = 0.005, stiffness = 1.2e4, pretension = 20.0;  ///< m, N/m, N
  double encoder = 1.0e-5;                                            ///< rad
};

void write_tendon_model(const TendonSetup& setup, const std::filesystem::path& folder);
std::unique_ptr<TrialPlant> tendon_plant(TendonSetup setup, truth::Draw draw);

}  // namespace sinew::trials

// SPDX-License-Identifier: GPL-3.0-or-later
// Drives, lone joints and arms as they are drawn.
#pragma once

#include <optional>

#include "tests/blind/truth/jointed.h"

namespace sinew::trials {

enum class DrivenKind { motor, slide, joint, arm };

struct DrivenSetup {
  DrivenKind kind = DrivenKind::joint;
  Mechanics mechanics = Mechanics::own;
  Jointed jointed;
  Rhythm rhythm;
  std::vector<double> encoder;  ///< step of each position sensor
  bool loaded = false, resolved = false;
  bool weighs = false;  ///< gravity may act on it, whether the model has any or not
  /// The model knows no drives: links as they were drawn, neither rotor nor friction.
  std::optional<Chain> drawing;
  double load_mean = 0.0, load_swing = 0.0;
};

std::unique_ptr<TrialPlant> driven_plant(DrivenSetup setup, truth::Draw draw);

}  // namespace sinew::trials

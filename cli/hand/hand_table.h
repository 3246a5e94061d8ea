// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of the hand's real-time step, from its model (firmware/hand/hand_parameters.h).
#pragma once

#include <string>

#include "cli/hand/step_settings.h"
#include "firmware/hand/hand_parameters.h"
#include "symbolic/hand/hand.h"
#include "symbolic/parts/part.h"

namespace sinew {

/// What a table is made of.
struct HandTableSources {
  const Hand& hand;
  const TendonWithLever& tendon;
  const MotorParameters& motor;
  const StepSettings& settings;
};

/// The table, and how well the lever's polynomials follow the lever.
struct HandTable {
  hand_parameters parameters;
  double force_error = 0.0;       ///< N, largest
  double elongation_error = 0.0;  ///< m, largest
  double stiffness_error = 0.0;   ///< N/m, largest
};

/// Throws std::invalid_argument where the hand is not of the fingers that firmware/hand is composed
/// of, or the pretension is beyond the lever's travel.
HandTable hand_table(const HandTableSources& from);

/// hand_parameters.c. `origin`: the command and the models' hash, for its first lines.
std::string hand_table_text(const hand_parameters& table, const std::string& origin);

}  // namespace sinew

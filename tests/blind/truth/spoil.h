// SPDX-License-Identifier: GPL-3.0-or-later
// Faults of the data, not of the model.
#pragma once

#include <string>

#include "tests/blind/truth/plant.h"

namespace sinew::truth {

struct Spoiled {
  std::string text;   ///< CSV
  std::string fault;  ///< as the log reader names it
  std::string channel;
  long row = 0;  ///< line of the file, 0: anywhere
};

/// Draws a fault and plants it.
Spoiled spoil(const Table& log, Draw draw);

}  // namespace sinew::truth

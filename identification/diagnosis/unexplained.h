// SPDX-License-Identifier: GPL-3.0-or-later
// "None of the known causes": structure that a flexible family explains and no named cause does.
#pragma once

#include <string>
#include <vector>

#include "identification/diagnosis/select.h"
#include "identification/diagnosis/verdict.h"

namespace sinew::diagnosis {

/// Share of all structure found that names must account for, or none of the known causes is it.
inline constexpr double kNamesHold = 0.7;

/// Share of its gain that a name must keep beside unnamed structure.
inline constexpr double kStandsAlone = 0.4;

/// What names leave over.
struct Structure {
  Unexplained said;
  Model beside;       ///< the selection's model with every unnamed shape that was found
  double left = 1.0;  ///< cross-validated loss with them, share of the selection's
};

/// Looks for structure in what the selection leaves over, takes back names that only stood in for
/// it, and says what it depends on.
Structure find_unexplained(const Design& design, const Library& library, const Settings& settings,
                           Selection& selection);

/// A line in the residual's spectrum over time: frequency and family-wise probability.
struct SpectralLine {
  double frequency_hz = 0.0;
  double p_value = 1.0;
  double share = 0.0;   ///< of its segment's residual energy
  double of_all = 0.0;  ///< of all channels' in their units
};
SpectralLine strongest_line(const Design& design, const Model& model);

}  // namespace sinew::diagnosis

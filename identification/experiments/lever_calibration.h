// SPDX-License-Identifier: GPL-3.0-or-later
// The lever's sensor: force, path length and stiffness from counts (4.1).
#pragma once

#include <string>
#include <vector>

#include "identification/experiments/calibration_polynomial.h"
#include "identification/logs/log.h"
#include "symbolic/parts/lever.h"

namespace sinew {

struct LeverCalibrationResult {
  bool identified = false;
  LeverCalibration calibration;         ///< what lever_calibrated_state emits
  CalibrationPolynomial force, length;  ///< N and m over the normalised count
  double hysteresis = 0.0;              ///< N, largest distance of the loading and unloading curves
  double hysteresis_at = 0.0;           ///< N, mean force there
  double largest_force_error = 0.0;     ///< N, of all samples against the polynomial
  double largest_length_error = 0.0;    ///< m
  double stiffness_mismatch = 0.0;      ///< largest |-f'/dL' - df/dx measured| over the largest
  std::vector<std::string> missing;
};

/// Channels count, force and elongation (x = dL0 - dL). Force and length are fitted to the middle
/// of loading and unloading; the stiffness is -f'/dL' of those polynomials and cannot contradict
/// them. Without elongation only the force is fitted and the rest is said to be missing; without
/// loading and unloading both the force is half a loop off, and not identified.
LeverCalibrationResult calibrate_lever(const std::vector<Log>& logs, int highest = 9);

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
// Guiding friction from measurements: the fitted exponential (4.1) and the capstan law.
#pragma once

#include <string>
#include <vector>

#include "identification/experiments/bump_projection.h"
#include "identification/experiments/guiding_table.h"

namespace sinew {

/// Both laws for one series. The fitted law is F = share T (1 - e^(-C1 alpha)), C0 = share T: C0
/// grows with the tension T; the capstan law is the same with share = 1 and C1 = mu.
struct GuidingFit {
  Estimate share;                  ///< C0 over the tension
  Estimate C1;                     ///< 1/rad
  Estimate mu;                     ///< of the capstan law
  double mean_tension = 0.0;       ///< N; C0 = share * tension
  double largest_bending = 0.0;    ///< rad, measured
  double fitted_residual = 0.0;    ///< N, rms
  double capstan_residual = 0.0;   ///< N, rms
  bool fitted_identified = false;  ///< share and C1 apart from one another
  bool capstan_identified = false;
  /// The capstan law leaves more than the fitted one by chance in less than 1 of 20 cases.
  bool capstan_contradicted = false;
  std::vector<std::string> missing;

  Estimate C0(double tension) const;                    ///< N
  double fitted(double tension, double bending) const;  ///< N
  double capstan(double tension, double bending) const;
};

/// Least squares with Ceres; standard errors from the residuals. What a series cannot tell is in
/// `missing`, with the measurement that would.
GuidingFit fit_guiding(const GuidingSeries& series);

}  // namespace sinew

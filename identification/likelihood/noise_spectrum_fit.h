// SPDX-License-Identifier: GPL-3.0-or-later
// The noise's smooth spectrum, by restricted maximum likelihood from what everything together
// leaves over.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/likelihood/hypotheses.h"

namespace sinew::diagnosis {

/// log S(f) = sum over j of cosines(j) cos(pi j f / band_hz); S: variance of one real row of
/// to_band() (spectrum.h).
struct SmoothSpectrum {
  Eigen::VectorXd cosines;
  double band_hz = 1.0;
  double at(double frequency_hz) const;
};

/// What one bin tells of the spectrum.
struct BinEnergy {
  double frequency_hz = 0.0;
  double energy = 0.0;   ///< of the residual: real^2 + imaginary^2
  double freedom = 2.0;  ///< real rows that the fit has left in it: 2 less its leverage
};

/// Minimises sum of freedom log S + energy / S over the bins; energies above kClipped times the
/// spectrum count as that much.
SmoothSpectrum fit_spectrum(const std::vector<BinEnergy>& bins, double band_hz);

/// What rows are multiplied with to have unit variance, empty for segments of the other logs.
struct Whitening {
  Weights training, held_out;
};

/// From what a fit of the training logs with everything leaves over: the model, and a few shapes of
/// every hypothesis. `floor`: per channel, the variance of a sample that is not material, which
/// counts as noise.
Whitening whitening_of(const Design& design, const Hypotheses& all, const Eigen::VectorXd& floor);

}  // namespace sinew::diagnosis

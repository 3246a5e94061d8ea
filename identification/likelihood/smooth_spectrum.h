// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth spectrum of noise, by restricted maximum likelihood.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace sinew::diagnosis {

/// log S(f) = sum over j <= kCosines of coefficients(j) cos(pi j f / band_hz) + the last ones times
/// rises towards low frequencies, one a stretch of frequencies that the cosines do not resolve. A
/// rise is no fall, since what a sensor and its machine add does not vanish there, and no steeper
/// than that of a disturbance of first order. S: variance of one real row of to_band()
/// (spectrum.h).
struct SmoothSpectrum {
  Eigen::VectorXd coefficients;
  double band_hz = 1.0;
  double at(double frequency_hz) const;
};

/// What one bin tells of the spectrum.
struct BinEnergy {
  double frequency_hz = 0.0;
  double energy = 0.0;   ///< of the residual: real^2 + imaginary^2
  double freedom = 2.0;  ///< real rows that the fit has left in it: 2 less its leverage
};

/// What is taken to be so of a spectrum before there are bins.
struct SpectrumPrior {
  double flat_rows = 0.0;   ///< it is white: worth so many real rows; its level is always free
  bool rises_go_on = true;  ///< where a fit has left no bins it rises as beside it, or not at all
};

/// Minimises sum of freedom log S + energy / S over the bins; energies above kClipped times the
/// spectrum count as that much.
SmoothSpectrum fit_spectrum(const std::vector<BinEnergy>& bins, double band_hz,
                            const SpectrumPrior& prior = {});

}  // namespace sinew::diagnosis

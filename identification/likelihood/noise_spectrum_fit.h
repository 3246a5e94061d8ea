// SPDX-License-Identifier: GPL-3.0-or-later
// The noise's smooth spectrum, by restricted maximum likelihood from what a fit leaves over.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/likelihood/hypotheses.h"

namespace sinew::diagnosis {

/// log S(f) = sum over j <= kCosines of coefficients(j) cos(pi j f / band_hz) + the last one times
/// a rise towards low frequencies, which is never a fall: what a sensor and its machine add does
/// not vanish there, and where the fit takes all rows of the lowest bins nothing else says so. S:
/// variance of one real row of to_band() (spectrum.h).
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

/// Minimises sum of freedom log S + energy / S over the bins; energies above kClipped times the
/// spectrum count as that much. `flat_rows`: what is known of the spectrum beforehand counts as
/// much as so many real rows of white noise; its level is always free.
SmoothSpectrum fit_spectrum(const std::vector<BinEnergy>& bins, double band_hz,
                            double flat_rows = 0.0);

/// What is expected of the spectra of a log before it is looked at.
struct ExpectedSpectra {
  std::vector<SmoothSpectrum> of_channel;  ///< empty: white noise
  double rows = 0.0;  ///< real rows that this counts as; 0: nothing is expected
};

/// Segments of one log whose channels' targets are made of the same measured forces, so that a row
/// of one shares its noise with the same row of the others.
struct SharedNoise {
  std::vector<std::size_t> segments;
  Eigen::MatrixXd correlation;  ///< segments x segments, of rows of unit variance
};

/// What rows are multiplied with to have unit variance, empty for segments of the other logs.
struct Whitening {
  Weights training, held_out;
  std::vector<SmoothSpectrum> of_channel;  ///< in proportion to what was expected, where it was
  std::vector<SharedNoise> shared;         ///< of the training logs
  /// Of every row that has other variance besides, the share of its standard deviation that is the
  /// noise of `shared`; empty: all of it.
  Weights noise_share;
};

/// From what a fit of the training logs with everything leaves over: the model, and a few shapes of
/// every hypothesis. `floor`: per channel, the variance of a sample that is not material, which
/// counts as noise. The fit takes most rows of a short log at the frequencies of its motion, and
/// without an expectation the spectrum there is a guess.
Whitening whitening_of(const Design& design, const Hypotheses& all, const Eigen::VectorXd& floor,
                       const ExpectedSpectra& expected = {});

/// From what a model leaves over of the training logs.
Whitening whitening_beside(const Design& design, const Model& model, const Eigen::VectorXd& floor);

/// log of the determinant of what whitening multiplies the training logs' rows with: -1/2 log det
/// of their noise's covariance. `noise_share`, of errors of form, is not part of it.
double log_determinant(const Whitening& whitening);

}  // namespace sinew::diagnosis

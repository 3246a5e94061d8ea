// SPDX-License-Identifier: GPL-3.0-or-later
// The noise's smooth spectrum, by restricted maximum likelihood from what a fit leaves over.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/likelihood/hypotheses.h"
#include "identification/likelihood/smooth_spectrum.h"

namespace sinew::diagnosis {

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
/// counts as noise. The fit takes most rows of a short log at the frequencies of its motion: there
/// the spectrum rises no further, which shows most of what is hidden.
Whitening whitening_of(const Design& design, const Hypotheses& all, const Eigen::VectorXd& floor,
                       const ExpectedSpectra& expected = {});

/// From what a model leaves over of the training logs, fitted to all of them together.
Whitening whitening_beside(const Design& design, const Model& model, const Eigen::VectorXd& floor);

/// log of the determinant of what whitening multiplies the training logs' rows with: -1/2 log det
/// of their noise's covariance. `noise_share`, of errors of form, is not part of it.
double log_determinant(const Whitening& whitening);

}  // namespace sinew::diagnosis

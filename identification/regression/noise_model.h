// SPDX-License-Identifier: GPL-3.0-or-later
// The coloured noise of every segment: its spectrum, and what of it the spectrum leaves out.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Noise of one segment: a spectrum, and a level that varies over time.
struct NoiseModel {
  Eigen::VectorXd variance;  ///< per bin and real row
  Eigen::VectorXd level;     ///< per decimated sample, relative, mean square about 1
  Eigen::VectorXd leftover;  ///< per bin: energy of the weighted residual, leverage corrected
};

/// Noise spectrum of one residual in the band. `leverage` per bin is the energy of an orthonormal
/// basis of everything fitted there: a fit with k coefficients takes k degrees of freedom out of
/// the bins where its columns live, and the spectrum is raised by just that. share: of the log
/// that counts (Design::window).
Eigen::VectorXd noise_spectrum(const Eigen::VectorXd& residual, const Eigen::VectorXd& leverage,
                               double share);

/// Estimates the noise of every training segment from what is left over by a fit with the model
/// *and* all `saturating` columns, so that an effect that is not accepted yet is not taken for
/// noise; held-out segments stay empty.
std::vector<NoiseModel> estimate_noise(const Design& design, const Model& model,
                                       const std::vector<const LibraryColumns*>& saturating);

Weights whitening(const std::vector<NoiseModel>& noise);

/// Noise variance per sample of repeated runs: half the mean square of the difference of two
/// runs of the same motion, the floor no model can get below.
double repeat_noise_floor(const Eigen::VectorXd& first, const Eigen::VectorXd& second);

}  // namespace sinew::diagnosis

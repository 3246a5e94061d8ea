// SPDX-License-Identifier: GPL-3.0-or-later
// The coloured noise of every segment.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/regression/linear_fit.h"

namespace sinew::diagnosis {

/// Noise of one segment.
struct NoiseModel {
  Eigen::VectorXd variance;  ///< per bin and real row
};

/// Noise spectrum of one residual in the band. `leverage` per bin is the energy of an orthonormal
/// basis of everything fitted there: a fit with k coefficients takes k degrees of freedom out of
/// the bins where its columns live, and the spectrum is raised by just that. share: of the log
/// that counts (Design::window).
Eigen::VectorXd noise_spectrum(const Eigen::VectorXd& residual, const Eigen::VectorXd& leverage,
                               double share);

Weights whitening(const std::vector<NoiseModel>& noise);

/// Noise as seen from one model: of every segment, and what it whitens with.
struct NoiseView {
  std::vector<NoiseModel> noise;
  Weights weights;
};

/// Noise left over by a model alone: whatever it does not explain counts as noise. Held-out
/// segments stay empty.
NoiseView own_noise(const Design& design, const Model& model);

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// How well a force at one place explains what disturbances leave over.
#pragma once

#include <vector>

#include "identification/contacts/force_places.h"

namespace sinew::diagnosis {

/// What acts in one disturbance.
struct FittedForce {
  Eigen::MatrixXd course;   ///< samples x 3 in the base's frame at a link, else samples x 1
  double peak = 0.0;        ///< of its magnitude, N or N m
  double peak_error = 0.0;  ///< standard error there
  double worth = 0.0;       ///< of the score, against no force in this disturbance
};

/// A force may change as it likes with time; at a link it keeps its direction in each disturbance,
/// or changes that as well.
struct ForceFit {
  const ForcePlace* place = nullptr;
  bool one_direction = false;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< m, the link's frame; at a link
  std::vector<FittedForce> forces;                  ///< one a disturbance
  double deviance = 0.0;  ///< what is left over, and the force beside what is expected of it, in
                          ///< units of the noise, for independent samples
  double price = 0.0;     ///< of the course, by evidence; each other number costs the logarithm of
                          ///< that of independent samples

  double score() const { return deviance + price; }
};

/// What nothing but noise would leave over of the disturbed samples.
struct ForceNoise {
  Eigen::MatrixXd covariance;  ///< channels x channels, of what undisturbed motion leaves over
  Eigen::VectorXd standing;    ///< what friction may hold of each channel
  double independent = 1.0;    ///< of the samples
  double price = 0.0;          ///< of one number
};
/// `material_share`: of a channel's rms, what is not worth telling.
ForceNoise force_noise(const Disturbances& disturbances, double material_share);

/// -2 log p of what one sample of a recording leaves over, up to what is the same for all that may
/// explain it. An explanation that is off by more expects more to be left over, and says less.
double log_loss_at(const ForceNoise& noise, const LeftOver& r, Eigen::Index sample);

/// The better of both kinds at a link, by the score.
ForceFit fit_force(const Disturbances& disturbances, const ForceNoise& noise,
                   const ForcePlace& place);

}  // namespace sinew::diagnosis

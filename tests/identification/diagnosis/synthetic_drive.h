// SPDX-License-Identifier: GPL-3.0-or-later
// A drive with one hidden effect, written independently of the candidates: its friction is
// dynamic, its effects have other functional forms, its noise is coloured.
#pragma once

#include <string>
#include <vector>

#include "identification/regression/candidate.h"

namespace sinew::test {

using namespace diagnosis;

struct SyntheticDrive {
  Recording log;
  double period_in = 0.0;  ///< q for one motor turn
  double period_out = 0.0;
  /// What inertia, viscous friction, Coulomb friction and the offset contribute to the target.
  Eigen::MatrixXd parts;
  Eigen::Vector4d values;  ///< their coefficients
  double noise = 0.0;      ///< rms
};

/// Names of the effects that can be hidden; the same words as the candidates use.
const std::vector<std::string>& hidden_effects();

/// Effects nobody's library has.
const std::vector<std::string>& foreign_effects();

/// One log of `duration` s at 500 Hz. sizes[i]: rms of effect i orthogonal to the plain baseline
/// divided by the noise's rms.
SyntheticDrive simulate_drive(const std::vector<std::string>& effects,
                              const std::vector<double>& sizes, double duration, unsigned seed);

}  // namespace sinew::test

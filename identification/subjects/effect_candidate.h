// SPDX-License-Identifier: GPL-3.0-or-later
// An effect of symbolic/effects as a candidate: its columns come from the emitted regressors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/regression/candidate.h"
#include "runtime/sinew_catalogue.h"
#include "symbolic/effects/effect.h"

namespace sinew::diagnosis {

/// A joint of the recordings.
struct EffectPlace {
  int axis = 0;      ///< column of the recordings' matrices, and channel
  std::string name;  ///< "motor", "joint q21"
  bool revolute = true;
};

/// What a log covers at one joint, SI units.
struct LogScale {
  double low = 0.0, high = 1.0;    ///< position
  double speed = 1.0;              ///< largest |velocity|
  double duration = 1.0;           ///< s
  double load = 0.0;               ///< largest |load|
  double mobility = 1.0;           ///< acceleration that goes with an effort
  bool turns_on_bristles = false;  ///< the model's friction, which else turns with the speed
};
LogScale scale_of(const std::vector<Recording>& logs, int axis);

/// An effect's emitted regressor, without the expressions behind it: GiNaC counts references
/// without locks, so what searches run side by side holds none.
struct Regressor {
  explicit Regressor(const Effect& effect);
  const sinew_function* function = nullptr;
  Eigen::Index columns = 0;
  Eigen::Index states = 0;  ///< zero before the first sample
};

/// samples x columns at the given shape parameters. The recording needs q, qd, qdd, time, and the
/// signals "direction" and "jounce"; a missing load counts as zero. "acceleration" goes before qdd,
/// "carried" before the load.
Eigen::MatrixXd effect_columns(const Regressor& regressor, const Recording& log, int axis,
                               const Eigen::VectorXd& shape);

/// The candidate. Where `fixed` is given it holds all shape parameters, else they are searched
/// within the effect's limits.
Candidate effect_candidate(const Effect& effect, const EffectPlace& place, const LogScale& scale,
                           const std::optional<Eigen::VectorXd>& fixed = {});

}  // namespace sinew::diagnosis

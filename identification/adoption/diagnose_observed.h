// SPDX-License-Identifier: GPL-3.0-or-later
// One diagnosis of a rig whose sensors a model predicts, from log files to findings.
#pragma once

#include <functional>

#include "identification/adoption/diagnose.h"
#include "identification/subjects/observed_rig.h"

namespace sinew::diagnosis {

struct ObservedRequest {
  ObservedRig rig;
  Identified identified;  ///< what the model has learnt before
  std::string name, description, hash, kind;
  std::filesystem::path runtime;           ///< folder of the runtime's headers
  std::vector<std::string> logs, holdout;  ///< files
  std::vector<std::string> map;            ///< texts of --map
  Settings settings;
  std::function<void(const std::string& step, double share)> progress;  ///< may be empty
};

/// As diagnose(): explains what the observation leaves over, extends it and measures the gain on
/// the held-out logs through the regenerated C.
Diagnosis diagnose_observed(const ObservedRequest& request);

/// What a rig's model, with what it has learnt, says of its sensors in a log.
struct ObservedReplay {
  std::vector<std::string> columns;       ///< "time [s]", "force [N]", ...
  std::vector<std::vector<double>> rows;  ///< in the band that a diagnosis compares
  struct Error {
    std::string channel, unit;
    double rms = 0.0;  ///< of the sensor against what is said of it, as a report's domain "sensor"
  };
  std::vector<Error> errors;
};

/// Of the request's logs, which are one. Throws as diagnose_observed().
ObservedReplay replay_observed(const ObservedRequest& request);

}  // namespace sinew::diagnosis

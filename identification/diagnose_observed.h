// SPDX-License-Identifier: GPL-3.0-or-later
// One diagnosis of a rig whose sensors a model predicts, from log files to findings.
#pragma once

#include <functional>

#include "identification/channel_map.h"
#include "identification/diagnose.h"
#include "identification/observed_subject.h"

namespace sinew::diagnosis {

/// What is logged, and how it becomes recordings.
struct ObservedRig {
  Observation observation;
  std::vector<ObservedChannel> channels;
  std::vector<ChannelSpec> specs;       ///< of the log's columns
  std::string position, position_unit;  ///< what plots are over: Recording::q
  bool free_zero = false;               ///< every channel has a zero of its own in every log
  /// Signals, targets, q and qd of one stretch; q, qd and load may come from `model`.
  std::function<Recording(const Log& log, const sinew::Segment& segment,
                          const ObservedModel& model)>
      recording;
  /// Candidates beyond the observation's effects. May be empty.
  std::function<void(ObservedSubject&)> complete;
};

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

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// A rig whose sensors a model predicts: its channels, and how a log becomes recordings.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/logs/channel_map.h"
#include "identification/subjects/observed_subject.h"

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

}  // namespace sinew::diagnosis

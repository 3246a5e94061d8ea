// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of known mass that logs were recorded with: what they ask of the joints is no deviation.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "identification/logs/carried_payload.h"
#include "identification/regression/candidate.h"
#include "identification/subjects/effort_model.h"
#include "identification/subjects/rigid_candidates.h"

namespace sinew::diagnosis {

/// One load, which several logs may have carried.
struct KnownPayload {
  std::string link;
  double mass = 0.0;                      ///< kg; of one that a column tells, its largest
  std::optional<Eigen::Vector3d> centre;  ///< in the link's frame [m]
  std::vector<std::string> recordings;    ///< names
  std::vector<std::string> logs;          ///< files
  /// Its centre was fitted to logs that all carry it: nothing else tells it from the joints'
  /// offsets.
  bool is_free = false;
};

/// The load told, at the one link that can carry it. Throws std::invalid_argument where several
/// may be meant.
KnownPayload known_payload(const CarriedPayload* told, const RigidColumns& rigid);

/// Sets the centres that are not known, by least squares beside everything else that the logs can
/// tell: parameters of every link, where some log is without the load, and inertia, viscous and
/// Coulomb friction and an offset of every joint. Without the links' parameters their errors would
/// move the centre. Loads whose centre is known have their effort in the recordings. Throws
/// std::invalid_argument where the training logs do not carry the load, or its link does not move.
void fit_centres(const std::vector<Recording>& training, const EffortModel& model,
                 const RigidColumns& rigid, std::vector<KnownPayload>& payloads);

/// What is still free of such a centre beside everything that is looked for: the load's first
/// moments [kg m], of whose columns the recordings have the signal. Known as if without an error,
/// it would make an offset of the joint that feels the load's weight.
Candidate free_centre(const KnownPayload& payload);

/// Signal of these columns: samples x 3 for each joint.
std::string centre_signal(const KnownPayload& payload);

}  // namespace sinew::diagnosis

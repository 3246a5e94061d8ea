// SPDX-License-Identifier: GPL-3.0-or-later
// Stretches of logs in which far more is left over than in the rest of them, as while something
// that no log has pushes.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "identification/contacts/left_over.h"

namespace sinew::diagnosis {

/// Of causes, levels and disturbances, which settle in two or three.
inline constexpr int kMostTurns = 8;

/// A stretch of one recording: samples first to last - 1.
struct Disturbance {
  std::size_t recording = 0;  ///< index into Disturbances::left_over
  Eigen::Index first = 0, last = 0;
};

/// rms per channel that logs usually leave over: in motion, and where friction may hold a joint.
struct UsualLevels {
  Eigen::VectorXd moving, standing;
};

struct Disturbances {
  std::vector<Disturbance> list;    ///< in the order of the recordings and of time
  std::vector<LeftOver> left_over;  ///< by a fit to the rest of the training logs
  std::vector<SetAside> aside;
  UsualLevels training, held_out;  ///< of the rest

  const UsualLevels& levels_of(const LeftOver& r) const { return r.held_out ? held_out : training; }

  /// What happens in held-out logs alone is no cause: the logs disagree.
  bool in_training() const {
    return std::any_of(list.begin(), list.end(),
                       [this](const Disturbance& d) { return !left_over[d.recording].held_out; });
  }
};

/// A stretch is disturbed where a twentieth of a second leaves four times the usual rms over in
/// some channel, and that is worth telling. Usual is what the undisturbed rest leaves over, in
/// motion or at standstill as the case may be, found in turns. None are told where they come back
/// with the state of the motion, as what a friction or a stop leaves over does, or where they make
/// up most of a log.
Disturbances find_disturbances(const FitInTime& fit);

/// Whether much is disturbed in one that is not in the other, both of the same recordings.
bool differ(const Disturbances& one, const Disturbances& other);

/// Turns of `next`, which finds what is disturbed by what is left over without what was known to
/// be, until it finds the same again. Where turns lead around in a circle, what is disturbed in all
/// of them.
Disturbances settled(Disturbances known,
                     const std::function<Disturbances(const Disturbances&)>& next);

/// What another model leaves over of the same disturbances, fitted to the rest of the logs.
void leave_over(const FitInTime& fit, Disturbances& disturbances);

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
// Experiments for driven joints, and what logs of them would hold.
#include <algorithm>
#include <cmath>

#include "identification/subjects/driven_subject.h"
#include "identification/subjects/effect_candidate.h"
#include "identification/subjects/model_candidates.h"

namespace sinew::diagnosis {

using Eigen::Index;
using Eigen::VectorXd;

/// Of the smooth motion: steps of a sensor are no acceleration that a drive could follow.
MotionRange DrivenSubject::covered(std::size_t joint) const {
  const auto c = static_cast<Index>(joint);
  const LogScale seen = scale(joint);
  MotionRange range{seen.low, seen.high, 0.0, 0.0, 0.0};
  for (const Recording& log : problem_.training) {
    const auto largest = [&](const char* signal) {
      return log.signals.at(signal).col(c).cwiseAbs().maxCoeff();
    };
    range.speed = std::max(range.speed, largest("smooth_qd"));
    range.acceleration = std::max(range.acceleration, largest("smooth_qdd"));
    if (log.load.size() == 0) continue;
    const VectorXd load = log.load.col(c);
    Index at = 0;
    load.cwiseAbs().maxCoeff(&at);
    if (std::abs(load(at)) > std::abs(range.load)) range.load = load(at);
  }
  return range;
}

Recording DrivenSubject::planned(const PlannedMotion& motion) const {
  Recording r;
  r.name = motion.name;
  r.step = motion.step;
  const Index n = motion.position.rows();
  r.time = VectorXd::LinSpaced(n, 0.0, motion.step * static_cast<double>(n - 1));
  r.target.assign(static_cast<std::size_t>(problem_.channels), VectorXd::Zero(n));
  r.band_hz = problem_.training.front().band_hz;
  if (motion.load.size() > 0) r.load = motion.load;
  add_motion(motion.position, r);
  add_derivatives(r);
  add_sensor_errors(r);
  if (!problem_.training.front().standstills.empty()) add_standstills(r);
  add_model(r);
  set_directions(r);
  add_mechanism_signals(r);
  for (std::size_t j = 0; j < bristle_.size(); ++j)
    if (moves_links(j)) add_sensor_responses(known_, static_cast<int>(j), r);
  return r;
}

namespace {

/// A motion as it is worked out: at the rate that the logs are compared at. It is to be played at
/// their own.
PlannedMotion slowed(const PlannedMotion& motion, double compared_step) {
  const auto stride = static_cast<Index>(std::lround(compared_step / motion.step));
  if (stride < 2) return motion;
  PlannedMotion slow = motion;
  slow.step *= static_cast<double>(stride);
  const auto kept = Eigen::seqN(0, (motion.position.rows() - 1) / stride + 1, stride);
  slow.position = motion.position(kept, Eigen::all).eval();
  if (motion.load.size() > 0) slow.load = motion.load(kept).eval();
  return slow;
}

}  // namespace

std::vector<PlannedExperiment> DrivenSubject::experiments(int channel) const {
  std::vector<PlannedExperiment> list;
  if (tendons_) return list;
  std::vector<MotionRange> joints;
  for (std::size_t j = 0; j < bristle_.size(); ++j) joints.push_back(covered(j));
  const auto joint = static_cast<std::size_t>(channel);
  const MotionRange& own = joints[joint];
  if (!(own.high > own.low && own.speed > 0.0 && own.acceleration > 0.0)) return list;
  for (PlannedMotion& motion : planned_motions(joints, joint, logged_training_.front().step))
    list.push_back({motion, [this, motion] {
                      return planned(slowed(motion, problem_.training.front().step));
                    }});
  return list;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/wrist_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "identification/logs/filter.h"
#include "identification/subjects/effect_candidate.h"
#include "identification/subjects/sensor_reading.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr const char* angles[] = {"q71", "q73"};

/// Highest frequency of the motion [Hz], at a sampling period [s].
double wrist_cutoff(double period) {
  return std::min(30.0, 0.1 / period);
}

Recording recording_of(const Log& log, const sinew::Segment& segment,
                       const std::vector<int>& tendons) {
  Recording r;
  r.step = log.period;
  const Index n = segment.samples.rows();
  r.time = VectorXd::LinSpaced(n, segment.start,
                               segment.start + log.period * static_cast<double>(n - 1));
  r.log_start = log.segments.front().start;
  MatrixXd q(n, 2);
  const double cutoff = wrist_cutoff(log.period);
  for (Index j = 0; j < 2; ++j) {
    const int channel = log.channel(angles[j]);
    q.col(j) = segment.samples.col(channel).matrix();
    add_reading(angles[j], q.col(j), log.channels[static_cast<std::size_t>(channel)].quantum,
                cutoff, r);
  }
  Motion motion = differentiate(q, log.period, cutoff);
  r.q = std::move(motion.q);
  r.qd = std::move(motion.qd);
  r.qdd = std::move(motion.qdd);
  for (const int i : tendons)
    r.target.push_back(segment.samples.col(log.channel(fmt::format("theta_{}", i))).matrix());
  return r;
}

/// A dependence that all motors share: friction or play of the wrist itself.
Candidate common(Candidate family, int axis, Index channels) {
  family.channels.clear();
  family.place = angles[axis];
  for (LinearParameter& p : family.linear) p.per_log = false;
  family.columns = [own = family.columns, channels](const Recording& log, int channel,
                                                    const VectorXd& p) -> MatrixXd {
    if (channel >= channels) return {};
    return own(log, channel, p);
  };
  return family;
}

/// All motors' angles by one share that changes over the log, as where their pulleys fill.
void add_changing_pulleys(ObservedSubject& subject) {
  const Problem& problem = subject.problem();
  const double duration = scale_of(problem.training, 0).duration;
  std::vector<Candidate> motors;
  for (int channel = 0; channel < problem.channels; ++channel) {
    const LogSignal angle = [channel](const Recording& log) -> VectorXd {
      return log.signals.at("said").col(channel);
    };
    motors.push_back(changing_in_time("time x the motors' angles", angle, duration, 0, channel));
  }
  Candidate all = motors.front();
  all.channels.clear();
  all.place = "wrist";
  all.columns = [motors](const Recording& log, int channel, const VectorXd& shape) {
    return motors[static_cast<std::size_t>(channel)].columns(log, channel, shape);
  };
  subject.add_candidate(std::move(all), "");
}

void complete_wrist(ObservedSubject& subject) {
  Problem& problem = subject.problem();
  const auto channels = static_cast<Index>(problem.channels);
  const double cutoff = wrist_cutoff(problem.training.front().step);
  for (const char* angle : angles)
    add_coarse_sensor(subject, {angle, "quantisation of the angle sensor", angle, cutoff});
  add_changing_pulleys(subject);
  for (int axis = 0; axis < 2; ++axis) {
    const LogScale s = scale_of(problem.training, axis);
    const FlexibleRanges ranges{s.low, s.high, s.speed, 0.0, s.duration};
    // Friction and play of the wrist itself have no period.
    for (Candidate& c : flexible_families(ranges, axis, 0))
      if (c.nonlinear.empty()) subject.add_candidate(common(std::move(c), axis, channels), "");
    // One motor's play, friction or gear shows in its own angle alone.
    for (int channel = 0; channels > 1 && channel < problem.channels; ++channel)
      for (Candidate& c : flexible_families(ranges, axis, channel)) {
        c.place = subject.channels()[static_cast<std::size_t>(channel)].name;
        subject.add_candidate(std::move(c), "");
      }
  }
}

}  // namespace

ObservedRig wrist_rig(const WristParameters& wrist, const std::string& model,
                      const std::vector<int>& tendons) {
  if (tendons.empty())
    throw std::invalid_argument("a wrist's log needs the angle of at least one motor, theta_1 ...");
  WristParameters logged = wrist;
  logged.forearm_points.clear();
  logged.palm_points.clear();
  ObservedRig rig;
  rig.specs = wrist_channels(static_cast<int>(wrist.palm_points.size()));
  for (ChannelSpec& spec : rig.specs)
    if (spec.name.rfind("theta_", 0) == 0) spec.required = false;
  for (const int i : tendons) {
    logged.forearm_points.push_back(wrist.forearm_points[static_cast<std::size_t>(i - 1)]);
    logged.palm_points.push_back(wrist.palm_points[static_cast<std::size_t>(i - 1)]);
    rig.channels.push_back({fmt::format("theta_{}", i), "rad"});
  }
  rig.observation = wrist_observation(logged, model);
  // Places are the wrist's own numbers.
  for (ObservationEffect& effect : rig.observation.effects)
    if (effect.id == "pulley_radius")
      effect.place =
          fmt::format("motor {}", tendons[static_cast<std::size_t>(effect.outputs.front())]);
  rig.position = "q71";
  rig.position_unit = "rad";
  rig.free_zero = true;
  rig.recording = [tendons](const Log& log, const sinew::Segment& segment, const ObservedModel&) {
    return recording_of(log, segment, tendons);
  };
  rig.complete = complete_wrist;
  return rig;
}

}  // namespace sinew::diagnosis

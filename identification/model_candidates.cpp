// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/model_candidates.h"

#include <algorithm>
#include <cmath>

#include "identification/filter.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Candidate at(const EffectPlace& place, const std::string& name, LinearParameter parameter) {
  Candidate c;
  c.name = name;
  c.place = place.name;
  c.channels = {place.axis};
  c.linear = {std::move(parameter)};
  return c;
}

/// Which end of its play a sensor is at: the direction of the logged motion, and on its way from
/// one to the other while the log stands still.
VectorXd side_of_play(const VectorXd& velocity, double still) {
  VectorXd side(velocity.size());
  double last = 0.0;
  Index from = 0;
  for (Index k = 0; k < velocity.size(); ++k) {
    if (std::abs(velocity(k)) <= still && k + 1 < velocity.size()) continue;
    const double now = std::abs(velocity(k)) <= still ? last : velocity(k) > 0.0 ? 1.0 : -1.0;
    if (last == 0.0) last = now;
    const auto way = static_cast<double>(k - from + 1);
    // The true motion starts from rest where the logged one stops: the way grows with the square.
    for (Index i = from; i <= k; ++i) {
      const double part = static_cast<double>(i - from + 1) / way;
      side(i) = last + (now - last) * part * part;
    }
    last = now;
    from = k + 1;
  }
  return side;
}

/// Change of the effort at one axis for a small change of the motion there, per `size`.
VectorXd response(const EffortModel& effort, const Recording& log, int axis, const Motion& change,
                  double size) {
  MatrixXd q = log.q, qd = log.qd, qdd = log.qdd;
  q.col(axis) += size * change.q.col(0);
  qd.col(axis) += size * change.qd.col(0);
  qdd.col(axis) += size * change.qdd.col(0);
  // Not from signal "known": of a thinned log that is filtered, and no effort of its motion.
  return (effort(log, q, qd, qdd).col(axis) - effort(log).col(axis)) / size;
}

}  // namespace

Candidate delay_candidate(const EffectPlace& place) {
  Candidate c = at(place, "delay", {"delay", "s", 0.0, 1e300, false, {}});
  c.kind = CandidateKind::delay;
  c.nonlinear = {{"delay", "s", 0.0, 0.02, 1, false}};
  c.limit_meaning = "the force would follow the motion";
  c.isolating_experiment = "steps of the command at several speeds, logged at the highest rate";
  return c;
}

Candidate torque_constant_candidate(const EffectPlace& place) {
  Candidate c = at(place, "torque constant",
                   {"gain",
                    "1",
                    -std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity(),
                    false,
                    {}});
  c.isolating_experiment = "a known external load, for instance a weight held still";
  c.columns = [axis = place.axis](const Recording& log, int channel, const VectorXd&) -> MatrixXd {
    if (channel != axis) return {};
    return log.signals.at("effort").col(axis);
  };
  return c;
}

Candidate sensor_low_pass_candidate(const EffectPlace& place, const EffortModel& effort) {
  Candidate c =
      at(place, "low-pass of the position sensor", {"time_constant", "s", 0.0, 0.1, false, {}});
  c.nonlinear = {{"time_constant_of_motion", "s", 1e-3, 0.05, 4, true}};
  c.limit_meaning = "the sensor would run ahead of the motion";
  c.isolating_experiment = "fast sinusoids against a second sensor";
  c.columns = [axis = place.axis, effort](const Recording& log, int channel,
                                          const VectorXd& constant) -> MatrixXd {
    if (channel != axis) return {};
    // The true motion is the logged one plus the time constant times its rate.
    const Motion rate{log.qd.col(axis), log.qdd.col(axis), log.signals.at("jerk").col(axis)};
    return response(effort, log, axis, rate, constant(0));
  };
  return c;
}

Candidate sensor_scale_candidate(const EffectPlace& place, const EffortModel& effort) {
  Candidate c =
      at(place, "scale of the position sensor", {"scale_error", "1", -0.5, 0.5, false, {}});
  c.isolating_experiment = "the travel between two stops, measured with a gauge";
  c.columns = [axis = place.axis, effort](const Recording& log, int channel,
                                          const VectorXd&) -> MatrixXd {
    if (channel != axis) return {};
    // The true motion is the logged one divided by 1 + scale_error.
    const Motion change{-log.q.col(axis), -log.qd.col(axis), -log.qdd.col(axis)};
    return response(effort, log, axis, change, 1e-4);
  };
  return c;
}

Candidate sensor_quantisation_candidate(const EffectPlace& place, const EffortModel& effort) {
  // 1: all of the difference between the logged and the smooth motion is the sensor's.
  Candidate c = at(place, "quantisation of the position sensor",
                   {"share_of_steps", "1", 0.0, 1.5, false, {}});
  c.limit_meaning = "the motion would be rougher than what is logged of it";
  c.broadband = true;
  c.isolating_experiment = "the same motion against a finer sensor";
  c.columns = [axis = place.axis, effort](const Recording& log, int channel,
                                          const VectorXd&) -> MatrixXd {
    if (channel != axis) return {};
    const auto change = [&](const char* smooth, const MatrixXd& logged) -> MatrixXd {
      return log.signals.at(smooth).col(axis) - logged.col(axis);
    };
    return response(
        effort, log, axis,
        {change("smooth_q", log.q), change("smooth_qd", log.qd), change("smooth_qdd", log.qdd)},
        1.0);
  };
  return c;
}

Candidate sensor_noise_candidate(const EffectPlace& place, const EffortModel& effort) {
  Candidate c = sensor_quantisation_candidate(place, effort);
  c.name = "noise of the position sensor";
  c.linear.front().name = "share_of_noise";
  return c;
}

Candidate sensor_hysteresis_candidate(const EffectPlace& place, const EffortModel& effort,
                                      const LogScale& scale) {
  Candidate c =
      at(place, "hysteresis of the position sensor",
         {"half_play", place.revolute ? "rad" : "m", 0.0, scale.high - scale.low, false, {}});
  c.limit_meaning = "the sensor would run ahead of the motion";
  c.isolating_experiment = "slow reversals against a second sensor";
  c.columns = [axis = place.axis, effort, still = 2e-3 * scale.speed,
               small = 1e-5 * (scale.high - scale.low)](const Recording& log, int channel,
                                                        const VectorXd&) -> MatrixXd {
    if (channel != axis) return {};
    const MatrixXd side = side_of_play(log.qd.col(axis), still);
    return response(effort, log, axis,
                    differentiate(side, log.step, std::min(40.0, 0.1 / log.step)), small);
  };
  return c;
}

}  // namespace sinew::diagnosis

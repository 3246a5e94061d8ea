// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/model_candidates.h"

#include <algorithm>

#include "identification/filter.h"
#include "symbolic/effects/effects.h"

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

VectorXd central_rate(const VectorXd& x, double step) {
  VectorXd rate = VectorXd::Zero(x.size());
  for (Index k = 1; k + 1 < x.size(); ++k) rate(k) = (x(k + 1) - x(k - 1)) / (2.0 * step);
  return rate;
}

/// Change of the effort at one axis for a small change of the motion there, per `size`.
VectorXd response(const EffortModel& effort, const Recording& log, int axis, const Motion& change,
                  double size) {
  MatrixXd q = log.q, qd = log.qd, qdd = log.qdd;
  q.col(axis) += size * change.q.col(0);
  qd.col(axis) += size * change.qd.col(0);
  qdd.col(axis) += size * change.qdd.col(0);
  return (effort(log, q, qd, qdd).col(axis) - log.signals.at("effort").col(axis)) / size;
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

Candidate sensor_low_pass_candidate(const EffectPlace& place) {
  Candidate c =
      at(place, "low-pass of the position sensor", {"time_constant", "s", 0.0, 0.1, false, {}});
  c.limit_meaning = "the sensor would run ahead of the motion";
  c.isolating_experiment = "fast sinusoids against a second sensor";
  c.columns = [axis = place.axis](const Recording& log, int channel, const VectorXd&) -> MatrixXd {
    if (channel != axis) return {};
    VectorXd effort = log.signals.at("effort").col(axis);
    if (log.load.size() > 0) effort -= log.load.col(axis);  // known apart from the position
    return central_rate(effort, log.step);
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

Candidate sensor_hysteresis_candidate(const EffectPlace& place, const EffortModel& effort,
                                      const LogScale& scale) {
  Candidate c =
      at(place, "hysteresis of the position sensor",
         {"half_play", place.revolute ? "rad" : "m", 0.0, scale.high - scale.low, false, {}});
  c.nonlinear = {{"turning_way", place.revolute ? "rad" : "m", 1e-4 * (scale.high - scale.low),
                  3e-2 * (scale.high - scale.low), 4, true}};
  c.limit_meaning = "the sensor would run ahead of the motion";
  c.isolating_experiment = "slow reversals against a second sensor";
  c.columns = [axis = place.axis, effort, bristle = Regressor(find_effect("presliding"))](
                  const Recording& log, int channel, const VectorXd& way) -> MatrixXd {
    if (channel != axis) return {};
    const MatrixXd side = effect_columns(bristle, log, axis, way);
    const Motion change = differentiate(side, log.step, std::min(100.0, 0.1 / log.step));
    const double small = 1e-3 * way(0);
    return response(effort, log, axis, change, small);
  };
  return c;
}

}  // namespace sinew::diagnosis

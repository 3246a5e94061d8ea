// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/subjects/model_candidates.h"

#include <algorithm>

#include "identification/logs/filter.h"
#include "symbolic/effects/model_effects.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kTolerance = 0.1;  // of a torque constant, as data sheets have it
constexpr double kSmallScale = 1e-4, kSmallTime = 1e-3;  // of the derivatives; 1, s
constexpr double kFarOffset = 0.1, kFarScale = 0.25;     // of the secants: rad or m, 1

/// Named, limited and told apart as the effect says.
Candidate of_effect(const std::string& id, const EffectPlace& place, LinearParameter parameter) {
  const ModelEffect& effect = *find_model_effect(id);
  Candidate c;
  c.name = effect.name;
  c.limit_meaning = effect.limit;
  c.isolating_experiment = effect.experiment;
  c.place = place.name;
  c.channels = {place.axis};
  c.linear = {std::move(parameter)};
  return c;
}

/// An effect is as large as its linear coefficient says; the size its shape was made for, which
/// small effects leave open, must not be larger by that factor.
auto of_its_size(double factor) {
  return [factor](const VectorXd& coefficients, const VectorXd& nonlinear) {
    return nonlinear(0) < factor * coefficients(0);
  };
}

/// The logged motion with a small change of it at one axis.
Motion changed_motion(const Recording& log, int axis, const Motion& change, double size) {
  Motion motion{log.q, log.qd, log.qdd};
  motion.q.col(axis) += size * change.q.col(0);
  motion.qd.col(axis) += size * change.qd.col(0);
  motion.qdd.col(axis) += size * change.qdd.col(0);
  return motion;
}

/// All efforts after it.
MatrixXd changed_effort(const EffortModel& effort, const Recording& log, int axis,
                        const Motion& change, double size) {
  const Motion motion = changed_motion(log, axis, change, size);
  return effort(log, motion.q, motion.qd, motion.qdd);
}

MatrixXd logged_effort(const EffortModel& effort, const Recording& log) {
  const MatrixXd* found = log.signals.find(effort_of_logged_motion);
  return found ? *found : effort(log);
}

/// Change of the axis' own effort for a small change of its motion, per `size`.
VectorXd response(const EffortModel& effort, const Recording& log, int axis, const Motion& change,
                  double size) {
  const MatrixXd* found = log.signals.find(effort_of_logged_motion);
  const VectorXd now =
      found ? VectorXd(found->col(axis)) : effort.of_joint(axis, log, log.q, log.qd, log.qdd);
  const Motion motion = changed_motion(log, axis, change, size);
  return (effort.of_joint(axis, log, motion.q, motion.qd, motion.qdd) - now) / size;
}

/// Change of a channel's effort for a change of the axis' motion by `size`, per `size`.
VectorXd secant(const EffortModel& effort, const Recording& log, int axis, int channel,
                const Motion& change, double size) {
  if (channel == axis) return response(effort, log, axis, change, size);
  return (changed_effort(effort, log, axis, change, size) - logged_effort(effort, log))
             .col(channel) /
         size;
}

/// The true motion is the logged one plus that much of its rate.
Motion rate_of(const Recording& log, int axis) {
  return {log.qd.col(axis), log.qdd.col(axis), log.signals.at("jerk").col(axis)};
}

/// A signal that many samples ahead of itself, its end held.
VectorXd earlier(const VectorXd& x, double samples) {
  const auto whole = static_cast<Index>(samples);
  const double part = samples - static_cast<double>(whole);
  VectorXd ahead(x.size());
  for (Index k = 0; k < x.size(); ++k) {
    const Index at = std::min(k + whole, x.size() - 1), next = std::min(at + 1, x.size() - 1);
    ahead(k) = x(at) + part * (x(next) - x(at));
  }
  return ahead;
}

/// The true position is by one unit less than the logged one.
Motion unit_less(const Recording& log) {
  const VectorXd none = VectorXd::Zero(log.q.rows());
  return {VectorXd::Constant(none.size(), -1.0), none, none};
}

/// The true acceleration is by one unit more than the logged one.
Motion accelerated(const Recording& log) {
  const VectorXd none = VectorXd::Zero(log.q.rows());
  return {none, none, VectorXd::Ones(none.size())};
}

/// The true motion is that much less than the logged one.
Motion less_of(const Recording& log, int axis) {
  return {-log.q.col(axis), -log.qd.col(axis), -log.acceleration().col(axis)};
}

/// What a rough error of an axis' logged position makes of the efforts: at other joints by its
/// acceleration alone.
Candidate sensor_error(const EffectPlace& place, const EffortModel& effort,
                       const std::vector<int>& coupled, const std::string& share,
                       const std::function<Motion(const Recording&)>& error) {
  Candidate c = of_effect("sensor_quantisation", place, {share, "1", 0.0, 1.5, false, {}});
  c.channels = coupled;
  c.columns = [axis = place.axis, effort, error](const Recording& log, int channel,
                                                 const VectorXd&) -> MatrixXd {
    const Motion change = error(log);
    if (channel == axis) return response(effort, log, axis, change, 1.0);
    return log.signals.at(mass_matrix_column(axis)).col(channel).cwiseProduct(change.qdd.col(0));
  };
  return c;
}

}  // namespace

Candidate delay_candidate(const EffectPlace& place) {
  Candidate c = of_effect("delay", place, {"delay", "s", 0.0, 1e300, false, {}});
  c.kind = CandidateKind::delay;
  c.nonlinear = {{"delay", "s", -0.02, 0.02, 9, false}};
  return c;
}

Candidate common_delay_candidate() {
  Candidate c = delay_candidate({0, "all joints", true});
  c.channels.clear();
  return c;
}

Candidate torque_constant_candidate(const EffectPlace& place) {
  Candidate c =
      of_effect("torque_constant", place, {"gain", "1", -0.6, 1.5, false, {}, kTolerance});
  c.columns = [axis = place.axis](const Recording& log, int channel, const VectorXd&) -> MatrixXd {
    if (channel != axis) return {};
    return log.signals.at("effort").col(axis);
  };
  return c;
}

std::string scale_response(int axis) {
  return "scale_response_" + std::to_string(axis);
}

std::string rate_response(int axis) {
  return "rate_response_" + std::to_string(axis);
}

std::string offset_response(int axis) {
  return "offset_response_" + std::to_string(axis);
}

std::string far_scale_response(int axis) {
  return "far_scale_response_" + std::to_string(axis);
}

std::string far_offset_response(int axis) {
  return "far_offset_response_" + std::to_string(axis);
}

std::string mass_matrix_column(int axis) {
  return "mass_matrix_column_" + std::to_string(axis);
}

MatrixXd mass_column(const EffortModel& effort, int axis, const Recording& log) {
  return changed_effort(effort, log, axis, accelerated(log), 1.0) - logged_effort(effort, log);
}

void add_sensor_responses(const EffortModel& effort, int axis, Recording& log) {
  const MatrixXd logged = logged_effort(effort, log);
  const auto add = [&](const std::string& name, const Motion& change, double size) {
    log.signals[name] = (changed_effort(effort, log, axis, change, size) - logged) / size;
  };
  add(offset_response(axis), unit_less(log), kSmallScale);
  add(far_offset_response(axis), unit_less(log), kFarOffset);
  add(scale_response(axis), less_of(log, axis), kSmallScale);
  add(far_scale_response(axis), less_of(log, axis), kFarScale);
  add(rate_response(axis), rate_of(log, axis), kSmallTime);
  log.signals[mass_matrix_column(axis)] = mass_column(effort, axis, log);
}

Candidate sensor_low_pass_candidate(const EffectPlace& place, const EffortModel& effort,
                                    const std::vector<int>& coupled, double friction) {
  Candidate c = of_effect("sensor_low_pass", place, {"time_constant", "s", 0.0, 0.1, false, {}});
  c.channels = coupled;
  c.nonlinear = {{"time_constant_of_motion", "s", 1e-3, 0.05, 4, true}};
  c.possible = of_its_size(2.0);
  c.columns = [axis = place.axis, effort, friction](const Recording& log, int channel,
                                                    const VectorXd& constant) -> MatrixXd {
    if (channel != axis) return log.signals.at(rate_response(axis)).col(channel);
    const VectorXd direction = log.signals.at("direction").col(axis);
    return response(effort, log, axis, rate_of(log, axis), constant(0)) +
           friction / constant(0) * (earlier(direction, constant(0) / log.step) - direction);
  };
  return c;
}

Candidate sensor_offset_candidate(const EffectPlace& place, const EffortModel& effort,
                                  const std::vector<int>& coupled) {
  constexpr double most = 2.0 * kFarOffset;
  Candidate c = of_effect("sensor_offset", place,
                          {"zero_offset", place.revolute ? "rad" : "m", -most, most, false, {}});
  c.channels = coupled;
  c.secant = kFarOffset;
  c.has_model_form = true;
  c.of_sensor = true;
  c.columns = [axis = place.axis, effort](const Recording& log, int channel,
                                          const VectorXd& size) -> MatrixXd {
    if (channel != axis && size.size() > 0 && size(0) == kFarOffset)
      return log.signals.at(far_offset_response(axis)).col(channel);
    if (size.size() > 0) return secant(effort, log, axis, channel, unit_less(log), size(0));
    if (channel != axis) return log.signals.at(offset_response(axis)).col(channel);
    return response(effort, log, axis, unit_less(log), kSmallScale);
  };
  return c;
}

Candidate sensor_scale_candidate(const EffectPlace& place, const EffortModel& effort,
                                 const std::vector<int>& coupled) {
  Candidate c = of_effect("sensor_scale", place,
                          {"scale_error", "1", -2.0 * kFarScale, 2.0 * kFarScale, false, {}});
  c.channels = coupled;
  c.secant = kFarScale;
  c.has_model_form = true;
  c.of_sensor = true;
  c.columns = [axis = place.axis, effort](const Recording& log, int channel,
                                          const VectorXd& size) -> MatrixXd {
    if (channel != axis && size.size() > 0 && size(0) == kFarScale)
      return log.signals.at(far_scale_response(axis)).col(channel);
    if (size.size() > 0) return secant(effort, log, axis, channel, less_of(log, axis), size(0));
    if (channel != axis) return log.signals.at(scale_response(axis)).col(channel);
    return response(effort, log, axis, less_of(log, axis), kSmallScale);
  };
  return c;
}

Candidate sensor_noise_candidate(const EffectPlace& place, const EffortModel& effort,
                                 const std::vector<int>& coupled) {
  // 1: all of the difference between the logged and the smooth motion is the sensor's.
  const auto error = [axis = place.axis](const Recording& log) {
    const auto change = [&](const char* smooth, const MatrixXd& logged) -> MatrixXd {
      return log.signals.at(smooth).col(axis) - logged.col(axis);
    };
    return Motion{change("smooth_q", log.q), change("smooth_qd", log.qd),
                  change("smooth_qdd", log.qdd)};
  };
  Candidate c = sensor_error(place, effort, coupled, "share_of_noise", error);
  c.name = "noise of the position sensor";
  return c;
}

Candidate sensor_quantisation_candidate(const EffectPlace& place, const EffortModel& effort,
                                        const std::vector<int>& coupled) {
  const auto error = [axis = place.axis](const Recording& log) {
    return Motion{-log.signals.at("steps").col(axis), -log.signals.at("steps_rate").col(axis),
                  -log.signals.at("steps_acceleration").col(axis)};
  };
  return sensor_error(place, effort, coupled, "share_of_steps", error);
}

Candidate sensor_hysteresis_candidate(const EffectPlace& place, const EffortModel& effort,
                                      const std::vector<int>& coupled, const LogScale& scale) {
  const std::string unit = place.revolute ? "rad" : "m";
  const double reach = scale.high - scale.low;
  Candidate c = of_effect("sensor_hysteresis", place, {"half_play", unit, 0.0, reach, false, {}});
  // Friction turns within the play: what the sensor hides of the motion is not proportional to it.
  c.nonlinear = {{"half_play_of_motion", unit, 1e-5 * reach, 3e-3 * reach, 4, true}};
  c.possible = of_its_size(4.0);
  c.sized_twice = true;
  c.channels = coupled;
  c.columns = [axis = place.axis, effort](const Recording& log, int channel,
                                          const VectorXd& half_play) -> MatrixXd {
    const Motion side{log.signals.at("side").col(axis), log.signals.at("side_rate").col(axis),
                      log.signals.at("side_acceleration").col(axis)};
    if (channel == axis) return response(effort, log, axis, side, half_play(0));
    return log.signals.at(mass_matrix_column(axis)).col(channel).cwiseProduct(side.qdd.col(0)) -
           log.signals.at(offset_response(axis)).col(channel).cwiseProduct(side.q.col(0));
  };
  return c;
}

}  // namespace sinew::diagnosis

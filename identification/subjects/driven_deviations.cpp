// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of the model's own values, as a diagnosis of driven joints may name them.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "identification/subjects/driven_subject.h"
#include "identification/subjects/expected_bodies.h"
#include "identification/subjects/model_candidates.h"
#include "symbolic/effects/effects.h"

namespace sinew::diagnosis {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void DrivenSubject::add_deviations(std::size_t joint) {
  const auto first = std::find_if(baseline_.begin(), baseline_.end(),
                                  [&](const auto& origin) { return origin.joint == joint; });
  const int base = static_cast<int>(first - baseline_.begin());
  const DrivenJoint& driven = model_.joints[joint];
  const double lowest[] = {-std::numeric_limits<double>::infinity(), -driven.damping,
                           -driven.friction, -std::numeric_limits<double>::infinity()};
  const char* effects[] = {"inertia", "viscous_level", "coulomb_level", "offset"};
  for (int k = 0; k < 4; ++k) {
    const Effect& effect = find_effect(effects[k]);
    const EffectColumn& column = effect.columns.front();
    DeviationParameter parameter;
    parameter.name = column.name;
    parameter.unit = unit_at(column.unit, driven.revolute);
    parameter.low = lowest[k];
    if (k == 0 && tendon_driven(joint)) parameter.high = most_inertia(joint);
    parameter.shares = {{base + k, 0, 1.0}};
    const bool bounded = std::isfinite(parameter.high);
    problem_.deviations.push_back(
        {effect.name,
         place(joint),
         {parameter},
         bounded ? "it would be negative, or far beyond any link's" : "it would be negative",
         effect.experiment,
         {}});
    deviations_.push_back({effects[k], joint, {}, {}});
  }
  add_common_deviations(joint);
  add_delay_deviation(delay_candidate({static_cast<int>(joint), place(joint), driven.revolute}),
                      {"delay", joint, {}, {}}, {static_cast<int>(joint)});
}

/// No link is that much heavier than its model: what would be is no inertia. [kg m²]
double DrivenSubject::most_inertia(std::size_t joint) const {
  constexpr double times_the_model = 30.0;
  const auto axis = static_cast<int>(joint);
  double largest = 0.0;
  for (const Recording& log : problem_.training)
    largest = std::max(largest, mass_column(known_, axis, log).col(axis).maxCoeff());
  return times_the_model * largest;
}

/// A delay moves inertia into damping and weight into friction: what the model says shows it, its
/// free values would not.
void DrivenSubject::add_delay_deviation(const Candidate& delay, CandidateOrigin origin,
                                        std::vector<int> channels) {
  ParameterDeviation deviation{
      delay.name,         delay.place, {}, delay.limit_meaning, delay.isolating_experiment,
      std::move(channels)};
  DeviationParameter parameter;
  parameter.name = delay.linear.front().name;
  parameter.unit = delay.linear.front().unit;
  parameter.low = delay.nonlinear.front().low;
  parameter.high = delay.nonlinear.front().high;
  deviation.parameters = {std::move(parameter)};
  deviation.of_sensor = true;
  problem_.deviations.push_back(std::move(deviation));
  deviations_.push_back(std::move(origin));
}

/// One parameter that moves several of the model's values at once.
void DrivenSubject::add_common_deviations(std::size_t joint) {
  const EffectPlace where{static_cast<int>(joint), place(joint), model_.joints[joint].revolute};
  if (tendon_driven(joint))
    add_deviation(pulley_radius_candidate(where.axis, where.name),
                  {"pulley_radius", joint, {}, {}});
  // Where tendons give the effort, the noise of their forces would pass for a gain.
  if (!tendons_)
    add_deviation(torque_constant_candidate(where), {"torque_constant", joint, {}, {}});
  if (model_.joints.size() == 1)
    add_deviation(sensor_scale_candidate(where, known_, {where.axis}),
                  {"sensor_scale", joint, {}, {}});
  if (is_lone_link() || (tendon_driven(joint) && moves_links(joint)))
    add_deviation(sensor_offset_candidate(where, known_, {where.axis}),
                  {"sensor_offset", joint, {}, {}});
}

void DrivenSubject::add_deviation(const Candidate& c, CandidateOrigin origin, int columns) {
  // Its columns are asked for without a shape.
  if (!c.nonlinear.empty())
    throw std::logic_error(c.name + " (" + c.place + ") has a shape and is no value of the model");
  ParameterDeviation deviation{c.name, c.place, {}, c.limit_meaning, c.isolating_experiment,
                               {},     false};
  const std::size_t count = columns < 0 ? c.linear.size() : static_cast<std::size_t>(columns);
  for (std::size_t k = 0; k < count; ++k) {
    const LinearParameter& p = c.linear[k];
    DeviationParameter parameter{p.name, p.unit, p.low, p.high, {}, {}, p.spread};
    parameter.also = [columns_of_all = c.columns, k](const Recording& log, int channel,
                                                     const VectorXd& shape) -> MatrixXd {
      const MatrixXd all = columns_of_all(log, channel, shape);
      if (all.cols() == 0) return all;
      return all.col(static_cast<Index>(k));
    };
    deviation.parameters.push_back(std::move(parameter));
  }
  deviation.unlikely = c.unlikely;
  deviation.body_within = c.body_within;
  deviation.of_body = c.of_body;
  deviation.of_sensor = c.of_sensor;
  problem_.deviations.push_back(std::move(deviation));
  deviations_.push_back(std::move(origin));
}

/// What acts on several joints looks like changes of their own values.
void DrivenSubject::add_mechanism_deviations() {
  if (model_.joints.size() > 1) {
    std::vector<int> all(model_.joints.size());
    std::iota(all.begin(), all.end(), 0);
    add_delay_deviation(common_delay_candidate(), {"delay", 0, {}, {}, true}, all);
  }
  if (is_lone_link()) add_carried_deviations();
  for (std::size_t i = 0; i < library_.size(); ++i) {
    const CandidateOrigin origin = library_[i];
    const Candidate candidate = problem_.library[i];
    const bool has_moments = candidate.linear.size() > kMassAndFirstMoments;
    if (origin.effect == "payload")
      add_deviation(candidate, origin, kMassAndFirstMoments);
    else if (origin.effect == "inertial_parameters" && !has_moments)
      add_deviation(candidate, origin);
    else if (origin.effect == "gravity" ||
             (!origin.tendon.empty() && candidate.nonlinear.empty() && candidate.secant == 0.0))
      add_deviation(candidate, origin);
  }
}

/// Where no weight shows, a link's mass is its inertia about the joint, and a rotor's is likelier.
bool DrivenSubject::shows_weight(const Candidate& mass) const {
  constexpr double kLeast = 0.01;  // of the column's energy beside the acceleration
  double own = 0.0, across = 0.0, acceleration = 0.0;
  for (const Recording& log : problem_.training) {
    const VectorXd x = mass.columns(log, 0, VectorXd()), a = log.acceleration().col(0);
    own += x.squaredNorm();
    across += x.dot(a);
    acceleration += a.squaredNorm();
  }
  return own * acceleration - across * across > kLeast * own * acceleration;
}

/// The free payloads of a lone joint, and its link's own mass.
void DrivenSubject::add_carried_deviations() {
  for (const auto& [candidate, effect] : rigid_->candidates())
    if (effect == "inertial_parameters" && shows_weight(candidate))
      add_deviation(candidate, {effect, 0, {}, {}});
  for (std::size_t t = 0; t < baseline_.size(); ++t) {
    if (baseline_[t].effect != "payload") continue;
    const Candidate& c = problem_.baseline[t];
    ParameterDeviation deviation{c.name, c.place, {}, c.limit_meaning, c.isolating_experiment,
                                 {},     false};
    for (std::size_t k = 0; k < c.linear.size(); ++k) {
      DeviationParameter parameter;
      parameter.name = c.linear[k].name;
      parameter.unit = c.linear[k].unit;
      if (parameter.name == "mass") parameter.low = 0.0;
      parameter.shares = {{static_cast<int>(t), static_cast<int>(k), 1.0}};
      deviation.parameters.push_back(std::move(parameter));
    }
    deviation.of_body = c.of_body;
    problem_.deviations.push_back(std::move(deviation));
    deviations_.push_back(baseline_[t]);
  }
}

/// Without a load, a weight and other joints, a wrong gain only scales what the baseline has: it
/// can be seen against the model's values alone.
bool DrivenSubject::gain_is_only_deviation(std::size_t joint) const {
  return model_.joints.size() == 1 && scale(joint).load == 0.0 && !carries_links(joint);
}

/// Its effort follows from the forces of tendons.
bool DrivenSubject::tendon_driven(std::size_t joint) const {
  return tendons_ && !model_.joints[joint].motor;
}

const CandidateOrigin& DrivenSubject::deviation_origin(int deviation) const {
  return deviations_.at(static_cast<std::size_t>(deviation));
}

}  // namespace sinew::diagnosis

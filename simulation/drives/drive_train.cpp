// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drives/drive_train.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generator/assemble.h"
#include "simulation/drives/motor_motion.h"
#include "simulation/drives/stored_energy.h"

namespace sinew {
namespace {

/// Newton steps of the emitted search: it starts at the last step's lever angle, so that few do.
constexpr int newton_iterations = 1;
/// Loops run over whole vectors: the last states of a count that is no multiple cost as many
/// vectors one by one. What is added is slack.
constexpr int vector_lanes = 8;

int whole_vectors(int count) {
  return (count + vector_lanes - 1) / vector_lanes * vector_lanes;
}

CompiledModel compiled(const std::string& name, const std::vector<Function>& functions,
                       const std::filesystem::path& runtime, bool with_batch = true) {
  return CompiledModel(assemble({name, "", "", {}}, functions, {}), runtime, with_batch);
}

TendonWithLever searched_from_nearby(TendonWithLever parameters) {
  parameters.lever.newton_iterations = newton_iterations;
  return parameters;
}

Function guiding_function(GuidingLaw law, const GuidingParameters& parameters) {
  return law == GuidingLaw::capstan ? capstan_transmitted_force(parameters)
                                    : guiding_friction_force(parameters);
}

}  // namespace

MotorParameters with_losses(MotorParameters parameters, const Scenario& scenario) {
  if (!scenario.motor_friction) parameters.gamma2 = parameters.gamma3 = 0.0;
  if (!scenario.motor_ripple) {
    parameters.output_ripple.clear();
    parameters.input_ripple.clear();
  }
  return parameters;
}

MotorModel::MotorModel(MotorParameters parameters, const Scenario& scenario,
                       const std::filesystem::path& runtime)
    : parameters_(with_losses(std::move(parameters), scenario)),
      plain_(compiled("motor", {motor_motion(parameters_, false)}, runtime)),
      compensated_(compiled("motor", {motor_motion(parameters_, true)}, runtime)),
      inertia_(motor_inertia(parameters_)),
      plain_motion_(plain_.batch<Motion>("motion")),
      compensated_motion_(compensated_.batch<Motion>("motion")) {}

void MotorModel::at(int count, const double* theta, const double* omega, const double* torque,
                    const double* force, double load, bool compensated, MotorStates& states) const {
  const int padded = whole_vectors(count);
  if (states.arguments.size() != 5 * padded) {
    states.arguments.setZero(5 * padded);
    states.results.resize(7 * padded);
  }
  double* in = states.arguments.data();
  for (const double* each : {theta, omega, torque, force}) {
    std::copy(each, each + count, in);
    in += padded;
  }
  std::fill(in, in + count, load);
  const double* all = states.arguments.data();
  double* out = states.results.data();
  (compensated ? compensated_motion_ : plain_motion_)(
      padded, all, all + padded, all + 2 * padded, all + 3 * padded, all + 4 * padded, out,
      out + padded, out + 2 * padded, out + 4 * padded);
  const auto part = [&](int k) { return states.results.segment(k * padded, count); };
  states.torque = part(0);
  states.acceleration = part(1);
  states.by_angle = part(2);
  states.by_speed = part(3);
  states.power = part(4).sum();
  states.friction_power = part(5).sum();
  states.ripple_power = part(6).sum();
}

double MotorModel::sticking_speed() const {
  const bool sticks = parameters_.gamma2 > 0.0 && parameters_.gamma1 > 0.0;
  return sticks ? 0.1 / parameters_.gamma1 : 0.0;
}

TendonModel::TendonModel(const TendonWithLever& parameters, const std::filesystem::path& runtime)
    : parameters_(searched_from_nearby(parameters)),
      energy_(parameters),
      model_(compiled("tendon", {tendon_force(parameters_.tendon, parameters_.lever)}, runtime)),
      search_(model_.batch<Search>("force")) {
  const LeverParameters& lever = parameters_.lever;
  const double softness = parameters_.tendon.free_length / parameters_.tendon.axial_stiffness;
  const CompiledModel end = compiled("lever", {lever_state(lever)}, runtime, false);
  const std::vector<double> state = end("state", {lever.end_angle});
  longest_ = state[1] + softness * state[2];
}

void TendonModel::at(int count, const double* elongation, const double* guess,
                     TendonStates& states) const {
  const int padded = whole_vectors(count);
  if (states.start.size() != 2 * padded) states.start.setZero(2 * padded);
  std::copy(elongation, elongation + count, states.start.data());
  std::copy(guess, guess + count, states.start.data() + padded);
  states.found.resize(4 * padded);
  double* found = states.found.data();
  search_(padded, states.start.data(), states.start.data() + padded, found, found + 3 * padded);
  states.stiffness = states.found.segment(padded, count);
  states.lever_angle = states.found.segment(2 * padded, count);
  states.residual = states.found.segment(3 * padded, count);
  for (int i = 0; i < count; ++i)
    if (elongation[i] > longest_) states.residual(i) = 0.0;
  states.force = states.found.head(count) + states.stiffness.cwiseProduct(states.residual);
}

double TendonModel::energy(const Eigen::VectorXd& elongation, const TendonStates& states) const {
  const auto count = static_cast<std::size_t>(elongation.size());
  angle_.resize(count);
  force_.resize(count);
  double rest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto t = static_cast<Eigen::Index>(i);
    const bool slack = elongation(t) <= 0.0;
    // The search stopped `residual` short of the elongation: up to there, and the rest.
    const double left = slack ? 0.0 : states.residual(t), stiffness = states.stiffness(t);
    angle_[i] = slack ? free_angle() : states.lever_angle(t);
    force_[i] = slack ? 0.0 : states.force(t) - stiffness * left;
    rest += force_[i] * (left + std::max(0.0, elongation(t) - longest_)) +
            0.5 * stiffness * left * left;
  }
  return energy_.at(count, angle_.data(), force_.data()) + rest;
}

double TendonModel::force_at(double elongation) const {
  double angle = free_angle(), found[3] = {}, residual = 1.0;
  for (int i = 0; i < 20 && std::abs(residual) > 1e-16; ++i) {
    search_(1, &elongation, &angle, found, &residual);
    angle = found[2];
  }
  return found[0];
}

double TendonModel::elongation_at(double force) const {
  double low = 0.0, high = longest_;
  if (force > force_at(high))
    throw std::invalid_argument(
        fmt::format("a pretension of {} N is beyond the lever's travel, "
                    "which ends at {:.4g} N",
                    force, force_at(high)));
  if (force <= 0.0) return 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (force_at(middle) < force ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

GuidingModel::GuidingModel(GuidingLaw law, const GuidingParameters& parameters,
                           const std::filesystem::path& runtime)
    : law_(law),
      model_(compiled("guiding", {guiding_function(law, parameters)}, runtime)),
      reversal_velocity_(parameters.reversal_velocity) {
  if (law_ == GuidingLaw::capstan)
    capstan_ = model_.batch<Capstan>("transmitted_force");
  else
    fitted_ = model_.batch<Fitted>("friction_force");
}

void GuidingModel::transmitted(int count, const double* tension, const double* bending,
                               const double* velocity, double* out) const {
  if (law_ == GuidingLaw::capstan) {
    capstan_(count, tension, bending, velocity, out);
    return;
  }
  fitted_(count, bending, velocity, out);
  // No tension, no normal force; the fitted form knows nothing of the tension.
  for (int i = 0; i < count; ++i)
    out[i] = std::max(0.0, tension[i] > 0.0 ? tension[i] + out[i] : 0.0);
}

}  // namespace sinew

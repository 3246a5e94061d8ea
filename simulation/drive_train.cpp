// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drive_train.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generator/assemble.h"
#include "simulation/stored_energy.h"

namespace sinew {
namespace {

/// Newton steps of the emitted search: it starts at the last step's lever angle, so that few do.
constexpr int newton_iterations = 3;

CompiledModel compiled(const std::string& name, const std::vector<Function>& functions,
                       const std::filesystem::path& runtime) {
  return CompiledModel(assemble({name, "", "", {}}, functions, {}), runtime);
}

MotorParameters with_losses(MotorParameters parameters, const Scenario& scenario) {
  if (!scenario.motor_friction) parameters.gamma2 = parameters.gamma3 = 0.0;
  if (!scenario.motor_ripple) {
    parameters.output_ripple.clear();
    parameters.input_ripple.clear();
  }
  return parameters;
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

MotorModel::MotorModel(MotorParameters parameters, const Scenario& scenario,
                       const std::filesystem::path& runtime)
    : parameters_(with_losses(std::move(parameters), scenario)),
      model_(compiled("motor", motor_functions(parameters_), runtime)),
      inertia_(motor_inertia(parameters_)),
      acceleration_(&model_.find("acceleration")),
      powers_(&model_.find("power_balance")),
      compensation_(&model_.find("compensation_torque")) {}

double MotorModel::sticking_speed() const {
  const bool sticks = parameters_.gamma2 > 0.0 && parameters_.gamma1 > 0.0;
  return sticks ? 0.1 / parameters_.gamma1 : 0.0;
}

double MotorModel::acceleration(double theta, double omega, double torque, double force) const {
  const double in[4] = {theta, omega, torque, force};
  double out = 0.0;
  acceleration_->call(in, &out);
  return out;
}

void MotorModel::powers(double theta, double omega, double torque, double force,
                        double* power) const {
  const double in[4] = {theta, omega, torque, force};
  powers_->call(in, power);
}

double MotorModel::compensation(double theta, double omega) const {
  const double in[2] = {theta, omega};
  double out[2];
  compensation_->call(in, out);
  return out[0];
}

TendonModel::TendonModel(const TendonWithLever& parameters, const std::filesystem::path& runtime)
    : parameters_(searched_from_nearby(parameters)),
      model_(compiled("tendon", tendon_force_functions(parameters_.tendon, parameters_.lever),
                      runtime)),
      force_(&model_.find("force")) {
  const LeverParameters& lever = parameters_.lever;
  const double softness = parameters_.tendon.free_length / parameters_.tendon.axial_stiffness;
  const CompiledModel end = compiled("lever", lever_functions(lever), runtime);
  const std::vector<double> state = end("state", {lever.end_angle});
  longest_ = state[1] + softness * state[2];
}

TendonState TendonModel::at(double elongation, double guess) const {
  const double in[2] = {elongation, guess};
  double out[4];
  force_->call(in, out);
  return {out[0], out[1], out[2], elongation > longest_ ? 0.0 : out[3]};
}

double TendonModel::energy(double elongation, const TendonState& state) const {
  if (elongation <= 0.0) return 0.0;
  return tendon_energy(parameters_, state.lever_angle, state.force) +
         state.force * std::max(0.0, elongation - longest_);
}

double TendonModel::elongation_at(double force) const {
  double low = 0.0, high = longest_;
  double angle = parameters_.lever.free_angle;
  // Steps that the search can follow, then halving: the force rises with the elongation.
  const auto force_at = [&](double elongation) {
    for (int i = 0; i < 20; ++i) angle = at(elongation, angle).lever_angle;
    return at(elongation, angle).force;
  };
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
      reversal_velocity_(parameters.reversal_velocity),
      function_(&model_.find(law == GuidingLaw::capstan ? "transmitted_force" : "friction_force")) {
}

double GuidingModel::transmitted(double tension, double bending, double velocity) const {
  double out = 0.0;
  if (law_ == GuidingLaw::capstan) {
    const double in[3] = {tension, bending, velocity};
    function_->call(in, &out);
    return out;
  }
  const double in[2] = {bending, velocity};
  function_->call(in, &out);
  // No tension, no normal force; the fitted form knows nothing of the tension.
  return std::max(0.0, tension > 0.0 ? tension + out : 0.0);
}

}  // namespace sinew

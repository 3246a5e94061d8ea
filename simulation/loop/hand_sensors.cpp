// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/loop/hand_sensors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>

namespace sinew {
namespace {

constexpr double noise = 0.5;         // counts, standard deviation before they are rounded
constexpr double earth = -9.81;       // m/s², along z of the forearm frame
constexpr double same_period = 1e-6;  // s

std::size_t column(const std::vector<std::string>& columns, const std::string& name) {
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end())
    throw std::invalid_argument(
        fmt::format("the simulated hand has no {}; expected a hand with motors (drive mode torque) "
                    "and a prescribed wrist",
                    name));
  return static_cast<std::size_t>(found - columns.begin());
}

}  // namespace

HandSensors::HandSensors(const Plant& plant, const hand_parameters& parameters)
    : plant_(plant), parameters_(parameters) {
  const std::vector<std::string> columns = output_columns(plant);
  const Scenario& scenario = plant.scenario();
  if (plant.motors() != HAND_TENDONS || plant.coordinates() != HAND_COORDINATES ||
      scenario.drive != DriveMode::torque)
    throw std::invalid_argument(fmt::format(
        "{}: the real-time step needs the complete hand in the drive mode torque", scenario.file));
  if (scenario.integrator != Integrator::fixed_step ||
      std::abs(1.0 / scenario.output_rate - parameters.period) > same_period ||
      std::abs(scenario.step - parameters.period) > same_period)
    throw std::invalid_argument(
        fmt::format("{}: the real-time step needs the integrator fixed_step with one step and one "
                    "row of output "
                    "a period of {:.9g} s",
                    scenario.file, parameters.period));
  theta_ = column(columns, "theta_1 [rad]");
  lever_ = column(columns, "lever_1 [rad]");
  wrist_ = column(columns, "q71 [rad]");
  const Eigen::VectorXd start = plant.initial_state();
  for (int j = 0; j < plant.coordinates(); ++j) {
    const std::string& name = plant.joints()->names[static_cast<std::size_t>(j)];
    const auto found = scenario.commands.find(name + "_ref");
    reference_.push_back(found == scenario.commands.end() ? nullptr : &found->second);
    start_.push_back(start(j));
  }
  const Eigen::Vector3d gravity = scenario.gravity.value_or(Eigen::Vector3d(0.0, 0.0, earth));
  for (int i = 0; i < 3; ++i) gravity_[i] = static_cast<float>(gravity(i));
}

std::uint32_t HandSensors::word(double count, double highest) {
  // The sum of four uniform numbers: near enough to Gaussian, and the same everywhere.
  double sum = -2.0;
  for (int i = 0; i < 4; ++i) sum += static_cast<double>(random_() >> 11) * 0x1p-53;
  const double read = std::round(count + noise * sum * std::numbers::sqrt3);
  return static_cast<std::uint32_t>(std::clamp(read, 0.0, highest)) | MAILBOX_VALID;
}

mailbox_measured HandSensors::measured(const std::vector<double>& row, std::uint32_t frame) {
  mailbox_measured m;
  std::memset(&m, 0, sizeof m);
  m.frame = m.frame_again = frame;
  const LeverParameters& lever = plant_.parts().tendon->lever();
  const double counts = (lever.count_end - lever.count_free) / (lever.end_angle - lever.free_angle);
  for (std::size_t i = 0; i < HAND_TENDONS; ++i) {
    m.motor[i] = static_cast<std::int32_t>(std::lround(row[theta_ + i] * counts_a_radian));
    m.sensor[i] = word(lever.count_free + counts * (row[lever_ + i] - lever.free_angle), 4095.0);
  }
  for (std::size_t i = 0; i < 2; ++i)
    m.wrist[i] =
        word((row[wrist_ + i] - parameters_.wrist_offset[i]) / parameters_.wrist_scale[i], 65535.0);
  return m;
}

mailbox_setpoint HandSensors::setpoint(double time) const {
  mailbox_setpoint s;
  std::memset(&s, 0, sizeof s);
  std::copy(gravity_, gravity_ + 3, s.gravity);
  for (std::size_t j = 0; j < HAND_COORDINATES; ++j) {
    const Sample wanted = reference_[j] ? reference_[j]->at(time) : Sample{start_[j], 0.0, 0.0};
    s.q[j] = static_cast<float>(wanted.value);
    s.qd[j] = static_cast<float>(wanted.rate);
    s.qdd[j] = static_cast<float>(wanted.acceleration);
  }
  return s;
}

}  // namespace sinew

// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

namespace sinew {
namespace {

constexpr std::size_t most_events = 1000;
constexpr double two_pi = 6.283185307179586;

/// Gaussian numbers that are the same with every standard library.
class Noise {
 public:
  explicit Noise(unsigned long seed) : random_(seed) {}
  double operator()(double deviation) {
    if (deviation == 0.0) return 0.0;
    const double u = uniform(), v = uniform();
    return deviation * std::sqrt(-2.0 * std::log(u)) * std::cos(two_pi * v);
  }

 private:
  /// In (0, 1].
  double uniform() { return (static_cast<double>(random_() >> 11) + 1.0) * 0x1p-53; }
  std::mt19937_64 random_;
};

/// A group of output channels: their names and unit, and how they are read off.
struct Group {
  std::vector<std::string> names;
  const char* unit;
  double noise;
  const Eigen::VectorXd Evaluation::*values;
};

std::vector<std::string> numbered(const std::string& name, int count) {
  std::vector<std::string> names;
  for (int i = 1; i <= count; ++i) names.push_back(fmt::format("{}_{}", name, i));
  return names;
}

std::vector<Group> drive_groups(const Plant& plant) {
  const MeasurementNoise& noise = plant.scenario().noise;
  std::vector<Group> groups{{{"theta"}, "rad", noise.theta, &Evaluation::theta},
                            {{"omega"}, "rad/s", noise.omega, &Evaluation::omega},
                            {{"tau_m"}, "N·m", noise.torque, &Evaluation::torque}};
  if (plant.scenario().drive == DriveMode::servo)
    groups.push_back({{"theta_ref"}, "rad", 0.0, &Evaluation::theta_reference});
  return groups;
}

std::vector<Group> joint_groups(const Plant& plant) {
  const MeasurementNoise& noise = plant.scenario().noise;
  const std::vector<std::string>& joints = plant.joints()->names;
  std::vector<std::string> rates;
  for (const std::string& joint : joints) rates.push_back("qd_" + joint);
  std::vector<Group> groups{{joints, "rad", noise.position, &Evaluation::q},
                            {rates, "rad/s", 0.0, &Evaluation::qd}};
  const int motors = plant.motors(), tendons = plant.tendons();
  if (motors > 0) {
    groups.push_back({numbered("theta", motors), "rad", noise.theta, &Evaluation::theta});
    groups.push_back({numbered("omega", motors), "rad/s", noise.omega, &Evaluation::omega});
    groups.push_back({numbered("tau", motors), "N·m", noise.torque, &Evaluation::torque});
  }
  if (tendons > 0)
    groups.push_back({numbered("force", tendons), "N", noise.force, &Evaluation::force});
  if (tendons > 0 && motors > 0)
    groups.push_back({numbered("lever", tendons), "rad", 0.0, &Evaluation::lever_angle});
  if (tendons == 0) {
    std::vector<std::string> torques;
    for (const std::string& joint : joints) torques.push_back("tau_" + joint);
    groups.push_back({torques, "N·m", noise.torque, &Evaluation::external});
  }
  return groups;
}

std::vector<Group> groups_of(const Plant& plant) {
  return plant.joints() ? joint_groups(plant) : drive_groups(plant);
}

class Recorder {
 public:
  Recorder(const Plant& plant, const OnRow& row, SimulationResult& result)
      : plant_(plant),
        row_(row),
        result_(result),
        groups_(groups_of(plant)),
        noise_(plant.scenario().noise.seed) {}

  void operator()(double time, const double* y, const Powers& work) {
    plant_.evaluate(time, y, e_, true);
    audit(work);
    std::vector<double> values{time};
    for (const Group& group : groups_)
      for (const double value : e_.*group.values) values.push_back(value + noise_(group.noise));
    if (!plant_.joints()) values.push_back(e_.load);
    if (plant_.parts().wrist) values.insert(values.end(), {e_.wrist.q[0], e_.wrist.q[1]});
    row_(values);
    ++result_.rows;
  }

 private:
  void audit(const Powers& work) {
    Audit& audit = result_.audit;
    const double energy = plant_.energy(e_);
    if (result_.rows == 0) start_ = energy;
    double sum = 0.0;
    for (const double each : work) {
      sum += each;
      audit.largest_energy = std::max(audit.largest_energy, std::abs(each));
    }
    audit.largest_energy = std::max(audit.largest_energy, std::abs(energy));
    audit.energy_drift = std::max(audit.energy_drift, std::abs(energy - start_));
    audit.energy_residual = std::max(audit.energy_residual, std::abs(energy - start_ - sum));
    audit.work = work;
    audit_power();
  }

  void audit_power() {
    Audit& audit = result_.audit;
    const Powers powers = plant_.powers(e_);
    const EnergyRate rate = plant_.energy_rate(e_);
    double sum = 0.0, size = rate.size;
    for (int i = 0; i < power_count; ++i) {
      const double power = powers[static_cast<std::size_t>(i)];
      if (i != base_power) sum += power;
      size = std::max(size, std::abs(power));
    }
    // Powers below a nanowatt are rounding of larger torques.
    audit.power_residual =
        std::max(audit.power_residual, std::abs(rate.total - sum) / (size + 1e-9));
    for (const Power loss : {motor_friction_power, guiding_power, damping_power})
      audit.largest_friction_power =
          std::max(audit.largest_friction_power, powers[static_cast<std::size_t>(loss)]);
  }

  const Plant& plant_;
  const OnRow& row_;
  SimulationResult& result_;
  std::vector<Group> groups_;
  Noise noise_;
  Evaluation e_;
  double start_ = 0.0;
};

}  // namespace

std::vector<std::string> output_columns(const Plant& plant) {
  std::vector<std::string> columns{"time [s]"};
  for (const Group& group : groups_of(plant))
    for (const std::string& name : group.names)
      columns.push_back(fmt::format("{} [{}]", name, group.unit));
  if (!plant.joints()) columns.push_back("load [N·m]");
  if (plant.parts().wrist)
    for (const char* name : {"q71 [rad]", "q73 [rad]"}) columns.push_back(name);
  return columns;
}

SimulationResult simulate(Plant& plant, const OnRow& row,
                          const std::function<void(double)>& progress) {
  SimulationResult result;
  Recorder recorder(plant, row, result);
  const auto start = std::chrono::steady_clock::now();
  result.count = integrate(
      plant,
      [&](double time, const double* y, const Powers& work) {
        recorder(time, y, work);
        if (progress) progress(time);
      },
      [&](const Event& event) {
        if (event.begins) ++result.event_counts[event.name];
        if (result.events.size() < most_events) result.events.push_back(event);
      });
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace sinew

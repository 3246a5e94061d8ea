// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/plant/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "symbolic/model/channel_name.h"

namespace sinew {
namespace {

constexpr std::size_t most_events = 1000;
using std::numbers::pi;

/// Gaussian numbers that are the same with every standard library.
class Noise {
 public:
  explicit Noise(unsigned long seed) : random_(seed) {}
  double operator()(double deviation) {
    if (deviation == 0.0) return 0.0;
    const double u = uniform(), v = uniform();
    return deviation * std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * pi * v);
  }

 private:
  /// In (0, 1].
  double uniform() { return (static_cast<double>(random_() >> 11) + 1.0) * 0x1p-53; }
  std::mt19937_64 random_;
};

/// A group of output channels: "name [unit]" each, and how they are read off.
struct Group {
  std::vector<std::string> columns;
  double noise;
  const Eigen::VectorXd& (*values)(const Evaluation&);
};

template <Eigen::VectorXd Evaluation::*member>
const Eigen::VectorXd& get(const Evaluation& e) {
  return e.*member;
}

const Eigen::VectorXd& lever_of(const Evaluation& e) {
  return e.tendon.lever_angle;
}

std::vector<std::string> numbered(const char* name, int count, const char* unit) {
  std::vector<std::string> columns;
  for (int i = 1; i <= count; ++i) columns.push_back(fmt::format("{}_{} [{}]", name, i, unit));
  return columns;
}

std::vector<Group> drive_groups(const Plant& plant) {
  const MeasurementNoise& noise = plant.scenario().noise;
  std::vector<Group> groups{{{"theta [rad]"}, noise.theta, get<&Evaluation::theta>},
                            {{"omega [rad/s]"}, noise.omega, get<&Evaluation::omega>},
                            {{"tau_m [N·m]"}, noise.torque, get<&Evaluation::logged_torque>}};
  if (plant.scenario().drive == DriveMode::servo)
    groups.push_back({{"theta_ref [rad]"}, 0.0, get<&Evaluation::theta_reference>});
  return groups;
}

std::vector<std::string> position_columns(const Joints& joints) {
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < joints.names.size(); ++i)
    columns.push_back(
        fmt::format("{} [{}]", position_channel(joints.names[i]), joints.slides[i] ? "m" : "rad"));
  return columns;
}

/// One column a coordinate, in the unit of those that turn or of those that slide.
std::vector<std::string> of_coordinates(const Joints& joints, const char* prefix,
                                        const char* turning, const char* sliding) {
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < joints.names.size(); ++i)
    columns.push_back(
        fmt::format("{}{} [{}]", prefix, joints.names[i], joints.slides[i] ? sliding : turning));
  return columns;
}

std::vector<Group> joint_groups(const Plant& plant) {
  const MeasurementNoise& noise = plant.scenario().noise;
  const Joints& joints = *plant.joints();
  std::vector<Group> groups{
      {position_columns(joints), noise.position, get<&Evaluation::q>},
      {of_coordinates(joints, "qd_", "rad/s", "m/s"), 0.0, get<&Evaluation::qd>}};
  const int motors = plant.motors(), tendons = plant.tendons();
  if (motors > 0) {
    groups.push_back({numbered("theta", motors, "rad"), noise.theta, get<&Evaluation::theta>});
    groups.push_back({numbered("omega", motors, "rad/s"), noise.omega, get<&Evaluation::omega>});
    groups.push_back(
        {numbered("tau", motors, "N·m"), noise.torque, get<&Evaluation::logged_torque>});
  }
  if (tendons > 0)
    groups.push_back(
        {numbered("force", tendons, "N"), noise.force, get<&Evaluation::logged_force>});
  if (tendons > 0 && motors > 0)
    groups.push_back({numbered("lever", tendons, "rad"), 0.0, lever_of});
  if (tendons == 0)
    groups.push_back({of_coordinates(joints, "tau_", "N·m", "N"), noise.torque,
                      get<&Evaluation::logged_external>});
  return groups;
}

std::vector<Group> groups_of(const Plant& plant) {
  return plant.joints() ? joint_groups(plant) : drive_groups(plant);
}

class Recorder {
 public:
  Recorder(const Plant& plant, const OnRow& row, const OnBooks& books, SimulationResult& result)
      : plant_(plant),
        row_(row),
        books_(books),
        result_(result),
        groups_(groups_of(plant)),
        noise_(plant.scenario().noise.seed) {}

  void row(double time, const double* y) {
    const Evaluation& shown = plant_.observed(time, y);
    values_.clear();
    values_.push_back(time);
    for (const Group& group : groups_) add(group, shown);
    if (!plant_.joints()) values_.push_back(shown.load);
    if (plant_.parts().wrist) values_.insert(values_.end(), {shown.wrist.q[0], shown.wrist.q[1]});
    row_(values_);
    ++result_.rows;
  }

  void audit(double time, const double* y, const Powers& work) {
    const Evaluation& e = plant_.evaluated(time, y, true);
    const EnergyNow now = plant_.energy(e);
    audit_energy(now.value, work);
    audit_power(e, now);
    if (books_) books_(time, now.value, work);
    if (plant_.tendons() > 0 && e.tendon.residual.size() > 0)
      result_.audit.lever_residual =
          std::max(result_.audit.lever_residual, e.tendon.residual.cwiseAbs().maxCoeff());
  }

 private:
  void add(const Group& group, const Evaluation& shown) {
    const Eigen::VectorXd& all = group.values(shown);
    if (group.noise == 0.0)
      values_.insert(values_.end(), all.begin(), all.end());
    else
      for (const double value : all) values_.push_back(value + noise_(group.noise));
  }

  void audit_energy(double energy, const Powers& work) {
    Audit& audit = result_.audit;
    if (!start_) start_ = energy;
    double sum = 0.0;
    for (const double each : work) {
      sum += each;
      audit.largest_energy = std::max(audit.largest_energy, std::abs(each));
    }
    audit.largest_energy = std::max(audit.largest_energy, std::abs(energy));
    audit.energy_drift = std::max(audit.energy_drift, std::abs(energy - *start_));
    audit.energy_residual = std::max(audit.energy_residual, std::abs(energy - *start_ - sum));
    audit.work = work;
  }

  void audit_power(const Evaluation& e, const EnergyNow& now) {
    Audit& audit = result_.audit;
    const Powers powers = plant_.powers(e);
    double sum = 0.0, size = now.size;
    for (int i = 0; i < power_count; ++i) {
      const double power = powers[static_cast<std::size_t>(i)];
      if (i != base_power) sum += power;
      size = std::max(size, std::abs(power));
    }
    // Powers below a nanowatt are rounding of larger torques.
    audit.power_residual = std::max(audit.power_residual, std::abs(now.rate - sum) / (size + 1e-9));
    for (const Power loss : {motor_friction_power, guiding_power, damping_power})
      audit.largest_friction_power =
          std::max(audit.largest_friction_power, powers[static_cast<std::size_t>(loss)]);
  }

  const Plant& plant_;
  const OnRow& row_;
  const OnBooks& books_;
  SimulationResult& result_;
  std::vector<Group> groups_;
  Noise noise_;
  std::vector<double> values_;
  std::optional<double> start_;
};

}  // namespace

std::vector<std::string> output_columns(const Plant& plant) {
  std::vector<std::string> columns{"time [s]"};
  for (const Group& group : groups_of(plant))
    columns.insert(columns.end(), group.columns.begin(), group.columns.end());
  if (!plant.joints()) columns.push_back("load [N·m]");
  if (plant.parts().wrist)
    for (const char* name : {"q71 [rad]", "q73 [rad]"}) columns.push_back(name);
  return columns;
}

SimulationResult simulate(Plant& plant, const OnRow& row,
                          const std::function<void(double)>& progress, const OnBooks& books) {
  SimulationResult result;
  Recorder recorder(plant, row, books, result);
  const auto start = std::chrono::steady_clock::now();
  IntegrationCalls calls;
  calls.output = [&](double time, const double* y) {
    recorder.row(time, y);
    if (progress) progress(time);
  };
  calls.step = [&](double time, const double* y, const Powers& work) {
    recorder.audit(time, y, work);
  };
  calls.event = [&](const Event& event) {
    if (event.begins) ++result.event_counts[event.name];
    if (result.events.size() < most_events) result.events.push_back(event);
  };
  result.count = integrate(plant, calls);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace sinew

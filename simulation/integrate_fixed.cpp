// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simulation/integrate.h"
#include "simulation/motion_solver.h"

namespace sinew {
namespace {

using Eigen::VectorXd;

class FixedSteps {
 public:
  FixedSteps(Plant& plant, const IntegrationCalls& calls)
      : plant_(plant), calls_(calls), y_(plant.initial_state()), names_(plant.event_names()) {
    signs_.resize(names_.size());
    plant_.events(0.0, y_.data(), signs_.data());
    last_power_ = powers_now();
    calls_.step(0.0, y_.data(), work_);
  }

  const VectorXd& state() const { return y_; }
  const IntegrationCount& count() const { return count_; }

  void step(double h) {
    if (plant_.scenario().integrator == Integrator::runge_kutta_4)
      runge_kutta(h);
    else
      linearly_implicit_euler(h);
    time_ += h;
    ++count_.steps;
    if (!y_.allFinite())
      throw std::runtime_error(fmt::format(
          "{}: the state is no longer finite at {:.6g} s; expected a smaller step or the "
          "integrator cvode_bdf",
          plant_.scenario().file, time_));
    plant_.accept(time_, y_.data());
    audit(h);
    watch();
  }

 private:
  VectorXd slope(double time, const VectorXd& y) {
    VectorXd dy(y.size());
    plant_.derivative(time, y.data(), dy.data());
    ++count_.evaluations;
    return dy;
  }

  void runge_kutta(double h) {
    const VectorXd a = slope(time_, y_), b = slope(time_ + h / 2, y_ + h / 2 * a),
                   c = slope(time_ + h / 2, y_ + h / 2 * b), d = slope(time_ + h, y_ + h * c);
    y_ += h / 6 * (a + 2 * b + 2 * c + d);
  }

  /// (I - h J) dy = h f(y): one linear solution, stable for stiff tendons and friction.
  void linearly_implicit_euler(double h) {
    change_ = h * slope(time_ + h, y_);
    plant_.jacobian(time_ + h, y_.data(), solver_.jacobian);
    ++count_.jacobians;
    solver_.prepare(h);
    solver_.solve(change_.data(), change_.data());
    y_ += change_;
  }

  Powers powers_now() { return plant_.powers(plant_.evaluated(time_, y_.data(), true)); }

  void audit(double h) {
    const Powers now = powers_now();
    for (std::size_t i = 0; i < power_count; ++i) work_[i] += h / 2 * (last_power_[i] + now[i]);
    last_power_ = now;
    calls_.step(time_, y_.data(), work_);
  }

  void watch() {
    std::vector<double> now(names_.size());
    plant_.events(time_, y_.data(), now.data());
    for (std::size_t i = 0; i < now.size(); ++i)
      if ((now[i] < 0.0) != (signs_[i] < 0.0)) calls_.event({time_, names_[i], now[i] < 0.0});
    signs_ = now;
  }

  Plant& plant_;
  const IntegrationCalls& calls_;
  VectorXd y_, change_;
  std::vector<std::string> names_;
  std::vector<double> signs_;
  MotionSolver solver_;
  double time_ = 0.0;
  Powers work_{}, last_power_{};
  IntegrationCount count_;
};

}  // namespace

double output_time(const Scenario& scenario, long k) {
  return std::min(static_cast<double>(k) / scenario.output_rate, scenario.duration);
}

long output_count(const Scenario& scenario) {
  // A duration that is a whole number of periods but for rounding has no row more.
  return static_cast<long>(std::ceil(scenario.duration * scenario.output_rate - 1e-6)) + 1;
}

IntegrationCount integrate_by_fixed_steps(Plant& plant, const IntegrationCalls& calls) {
  const Scenario& scenario = plant.scenario();
  FixedSteps steps(plant, calls);
  calls.output(0.0, steps.state().data());
  for (long k = 1; k < output_count(scenario); ++k) {
    const double period = output_time(scenario, k) - output_time(scenario, k - 1);
    const long substeps = std::max(1L, std::lround(std::ceil(period / scenario.step - 1e-9)));
    for (long i = 0; i < substeps; ++i) steps.step(period / static_cast<double>(substeps));
    calls.output(output_time(scenario, k), steps.state().data());
  }
  return steps.count();
}

IntegrationCount integrate(Plant& plant, const IntegrationCalls& calls) {
  const Integrator method = plant.scenario().integrator;
  return method == Integrator::cvode_bdf || method == Integrator::cvode_adams
             ? integrate_by_cvode(plant, calls)
             : integrate_by_fixed_steps(plant, calls);
}

}  // namespace sinew

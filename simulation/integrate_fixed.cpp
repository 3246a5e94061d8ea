// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simulation/integrate.h"

namespace sinew {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

class FixedSteps {
 public:
  FixedSteps(Plant& plant, const OnEvent& event)
      : plant_(plant), event_(event), y_(plant.initial_state()), names_(plant.event_names()) {
    signs_.resize(names_.size());
    plant_.events(0.0, y_.data(), signs_.data());
    last_power_ = powers_now();
  }

  const VectorXd& state() const { return y_; }
  const Powers& work() const { return work_; }
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
    const VectorXd f = slope(time_ + h, y_);
    plant_.jacobian(time_ + h, y_.data(), J_);
    ++count_.jacobians;
    const auto size = y_.size();
    y_ += (MatrixXd::Identity(size, size) - h * J_).partialPivLu().solve(h * f);
  }

  Powers powers_now() {
    plant_.evaluate(time_, y_.data(), evaluation_, true);
    count_.largest_residual = std::max(count_.largest_residual, evaluation_.residual);
    return plant_.powers(evaluation_);
  }

  void audit(double h) {
    const Powers now = powers_now();
    for (std::size_t i = 0; i < power_count; ++i) work_[i] += h / 2 * (last_power_[i] + now[i]);
    last_power_ = now;
  }

  void watch() {
    std::vector<double> now(names_.size());
    plant_.events(time_, y_.data(), now.data());
    for (std::size_t i = 0; i < now.size(); ++i)
      if ((now[i] < 0.0) != (signs_[i] < 0.0)) event_({time_, names_[i], now[i] < 0.0});
    signs_ = now;
  }

  Plant& plant_;
  const OnEvent& event_;
  VectorXd y_;
  std::vector<std::string> names_;
  std::vector<double> signs_;
  MatrixXd J_;
  Evaluation evaluation_;
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

IntegrationCount integrate_by_fixed_steps(Plant& plant, const OnOutput& output,
                                          const OnEvent& event) {
  const Scenario& scenario = plant.scenario();
  FixedSteps steps(plant, event);
  output(0.0, steps.state().data(), steps.work());
  for (long k = 1; k < output_count(scenario); ++k) {
    const double period = output_time(scenario, k) - output_time(scenario, k - 1);
    const long substeps = std::max(1L, std::lround(std::ceil(period / scenario.step - 1e-9)));
    for (long i = 0; i < substeps; ++i) steps.step(period / static_cast<double>(substeps));
    output(output_time(scenario, k), steps.state().data(), steps.work());
  }
  return steps.count();
}

IntegrationCount integrate(Plant& plant, const OnOutput& output, const OnEvent& event) {
  const Integrator method = plant.scenario().integrator;
  return method == Integrator::cvode_bdf || method == Integrator::cvode_adams
             ? integrate_by_cvode(plant, output, event)
             : integrate_by_fixed_steps(plant, output, event);
}

}  // namespace sinew

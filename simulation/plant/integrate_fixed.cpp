// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "simulation/plant/integrate.h"
#include "simulation/plant/motion_solver.h"

namespace sinew {
namespace {

using Eigen::VectorXd;

class FixedSteps {
 public:
  FixedSteps(Plant& plant, const IntegrationCalls& calls, double start, VectorXd state)
      : plant_(plant),
        calls_(calls),
        implicit_(plant.scenario().integrator != Integrator::runge_kutta_4 || plant.needs_steps()),
        y_(std::move(state)),
        names_(plant.event_names()),
        time_(start) {
    signs_.resize(names_.size());
    signs_now_.resize(names_.size());
    if (!calls_.step) return;
    plant_.events(time_, y_.data(), signs_.data());
    last_power_ = powers_now();
    calls_.step(time_, y_.data(), work_);
  }

  const VectorXd& state() const { return y_; }
  const IntegrationCount& count() const { return count_; }

  void step(double end) {
    const double h = end - time_;
    plant_.set_step(h);
    if (!implicit_)
      runge_kutta(h);
    else if (plant_.has_drives())
      implicit_euler(h);
    else
      linearly_implicit_euler(h);
    plant_.remember(time_, end, y_.data());
    time_ = end;
    ++count_.steps;
    if (!y_.allFinite())
      throw std::runtime_error(
          fmt::format("{}: the state is no longer finite at {:.6g} s; expected "
                      "a smaller step or the "
                      "integrator cvode_bdf",
                      plant_.scenario().file, time_));
    if (calls_.step) {
      audit(h);
      watch();
    }
    plant_.accept(time_, y_.data());
  }

 private:
  void slope(double time, const VectorXd& y, VectorXd& dy) {
    dy.resize(y.size());
    plant_.derivative(time, y.data(), dy.data());
    ++count_.evaluations;
  }

  void runge_kutta(double h) {
    slope(time_, y_, slopes_[0]);
    slope(time_ + h / 2, y_ + h / 2 * slopes_[0], slopes_[1]);
    slope(time_ + h / 2, y_ + h / 2 * slopes_[1], slopes_[2]);
    slope(time_ + h, y_ + h * slopes_[2], slopes_[3]);
    y_ += h / 6 * (slopes_[0] + 2 * slopes_[1] + 2 * slopes_[2] + slopes_[3]);
  }

  /// (I - h J) dy = h f(t, y): one evaluation, that of the last step's audit, and one linear
  /// solution; stable for stiff tendons and friction. Commands count from the start of the step, as
  /// a firmware's that holds them over a period.
  void linearly_implicit_euler(double h) {
    slope(time_, y_, change_);
    change_ *= h;
    plant_.jacobian(time_, y_.data(), solver_.jacobian);
    ++count_.jacobians;
    solver_.prepare(h);
    solver_.solve(change_.data(), change_.data());
    y_ += change_;
  }

  /// y = y_start + h f(start, y), commands held: friction next to rest turns within a step, and one
  /// linear solution would throw the motion from one side of it to the other. Newton's method, with
  /// steps that never make the rest larger.
  void implicit_euler(double h) {
    constexpr int kMost = 25;
    constexpr double kEnough = 1e-9;
    const VectorXd start = y_;
    linearly_implicit_euler(h);
    VectorXd rest = left_over(start, h, y_);
    for (int i = 0; i < kMost && size_of(rest, h) > kEnough * (1.0 + y_.norm()); ++i) {
      plant_.jacobian(time_, y_.data(), solver_.jacobian);
      ++count_.jacobians;
      solver_.prepare(h);
      solver_.solve(rest.data(), change_.data());
      double share = 1.0;
      VectorXd next = y_ - change_, left = left_over(start, h, next);
      while (share > 1e-3 && !(size_of(left, h) < size_of(rest, h))) {
        share *= 0.5;
        next = y_ - share * change_;
        left = left_over(start, h, next);
      }
      y_ = std::move(next);
      rest = std::move(left);
    }
  }

  VectorXd left_over(const VectorXd& start, double h, const VectorXd& y) {
    slope(time_, y, slopes_[0]);
    return y - start - h * slopes_[0];
  }

  /// In rates: a position is worth its change in a step.
  static double size_of(const VectorXd& rest, double h) {
    const Eigen::Index half = rest.size() / 2;
    return rest.head(half).norm() / h + rest.tail(half).norm();
  }

  Powers powers_now() { return plant_.powers(plant_.evaluated(time_, y_.data(), true)); }

  void audit(double h) {
    const Powers now = powers_now();
    for (std::size_t i = 0; i < power_count; ++i) work_[i] += h / 2 * (last_power_[i] + now[i]);
    last_power_ = now;
    calls_.step(time_, y_.data(), work_);
  }

  void watch() {
    plant_.events(time_, y_.data(), signs_now_.data());
    for (std::size_t i = 0; i < signs_.size(); ++i)
      if ((signs_now_[i] < 0.0) != (signs_[i] < 0.0))
        calls_.event({time_, names_[i], signs_now_[i] < 0.0});
    std::swap(signs_, signs_now_);
  }

  Plant& plant_;
  const IntegrationCalls& calls_;
  bool implicit_;
  VectorXd y_, change_, slopes_[4];
  std::vector<std::string> names_;
  std::vector<double> signs_, signs_now_;
  MotionSolver solver_;
  double time_;
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
  FixedSteps steps(plant, calls, 0.0, plant.initial_state());
  calls.output(0.0, steps.state().data());
  for (long k = 1; k < output_count(scenario); ++k) {
    const double start = output_time(scenario, k - 1), end = output_time(scenario, k);
    const long substeps =
        std::max(1L, std::lround(std::ceil((end - start) / scenario.step - 1e-9)));
    for (long i = 1; i < substeps; ++i)
      steps.step(start + (end - start) * static_cast<double>(i) / static_cast<double>(substeps));
    steps.step(end);
    calls.output(output_time(scenario, k), steps.state().data());
  }
  return steps.count();
}

void integrate_stretch(Plant& plant, double start, const Eigen::VectorXd& state, long steps,
                       const OnOutput& output) {
  const IntegrationCalls calls{output, {}, {}};
  FixedSteps stepped(plant, calls, start, state);
  for (long k = 1; k <= steps; ++k) {
    const double time = start + static_cast<double>(k) * plant.scenario().step;
    stepped.step(time);
    output(time, stepped.state().data());
  }
}

IntegrationCount integrate(Plant& plant, const IntegrationCalls& calls) {
  Integrator method = plant.scenario().integrator;
  if (plant.needs_steps()) method = Integrator::fixed_step;
  return method == Integrator::cvode_bdf || method == Integrator::cvode_adams
             ? integrate_by_cvode(plant, calls)
             : integrate_by_fixed_steps(plant, calls);
}

}  // namespace sinew

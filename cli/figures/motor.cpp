// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figures/motor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "identification/experiments/friction_curve.h"
#include "simulation/plant/simulate.h"
#include "symbolic/parts/part.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

using std::numbers::pi;
constexpr const char* simulated =
    "Simulated with the emitted C of models/motor, not measured: the source's motor is not "
    "available, and its ripple is not printed. ";

/// Columns of a run, SI units.
struct Run {
  Eigen::ArrayXd time, theta, omega, torque, reference;
  double period() const { return time(1) - time(0); }
};

Run run(const fs::path& model, const std::string& scenario, const fs::path& runtime) {
  Plant plant = build_plant(model, model / "scenarios" / (scenario + ".toml"), runtime);
  std::vector<std::vector<double>> rows;
  simulate(plant, [&](const std::vector<double>& row) { rows.push_back(row); });
  const std::vector<std::string> names = output_columns(plant);
  const auto column = [&](const std::string& name) {
    Eigen::ArrayXd values = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t c = 0; c < names.size(); ++c)
      if (names[c].rfind(name + " [", 0) == 0)
        for (std::size_t i = 0; i < rows.size(); ++i)
          values(static_cast<Eigen::Index>(i)) = rows[i][c];
    return values;
  };
  return {column("time"), column("theta"), column("omega"), column("tau_m"), column("theta_ref")};
}

/// Every n-th sample: a drawing has no use for more.
Series line(const std::string& title, const Eigen::ArrayXd& x, const Eigen::ArrayXd& y,
            long every = 1) {
  Series series{title, {}, {}};
  for (long i = 0; i < x.size(); i += every) {
    series.x.push_back(x(i));
    series.y.push_back(y(i));
  }
  return series;
}

Panel friction_panel(const FrictionCurve& curve) {
  Panel panel{"friction curve", "velocity [rad/s]", "torque [N m]", {}};
  Series mean{"mean", {}, {}, Look::line_and_dots},
      low{"minimum, maximum", {}, {}, Look::dashed, 1}, high{"", {}, {}, Look::dashed, 1},
      model{"(3.8) fitted", {}, {}, Look::thick};
  for (const FrictionPoint& p : curve.points) {
    for (Series* s : {&mean, &low, &high}) s->x.push_back(p.velocity);
    mean.y.push_back(p.torque);
    low.y.push_back(p.low);
    high.y.push_back(p.high);
  }
  const double fastest = curve.points.empty() ? 1.0 : curve.points.back().velocity;
  for (int i = -100; i <= 100; ++i) {
    model.x.push_back(fastest * i / 100.0);
    model.y.push_back(friction_torque(curve.gamma1.value, curve.gamma2.value, curve.gamma3.value,
                                      model.x.back()));
  }
  panel.series = {mean, low, high, model};
  return panel;
}

Figure figure_friction(const Run& log, double gear_ratio) {
  const DriveStretch stretch{log.period(), log.theta, log.omega, log.torque};
  const FrictionCurve curve = identify_friction({stretch}, gear_ratio);
  Figure figure{"figure_3_03", "3.3", "Friction from constant velocities (simulated)", "", {}};
  figure.panels = {
      {"position", "time [s]", "output angle [rad]", {line("", log.time, log.theta, 20)}},
      friction_panel(curve)};
  figure.differs = fmt::format(
      "{}Fitted: gamma1 = {:.4g} ± {:.2g} s/rad, gamma2 = {:.4g} ± {:.2g} N m, gamma3 = {:.4g} "
      "± {:.2g} N m s/rad, where the simulation has Table 3.3's 10, 0.5586 and 0.0356. The band "
      "between minimum and maximum is the ripple assumed, with noise.",
      simulated, curve.gamma1.value, curve.gamma1.standard_error, curve.gamma2.value,
      curve.gamma2.standard_error, curve.gamma3.value, curve.gamma3.standard_error);
  const auto fitted = [](const Estimate& e) {
    return fmt::format("{:.4g} ± {:.2g}", e.value, e.standard_error);
  };
  figure.numbers = {{"γ1 of (3.8) [s/rad]", "10 (Table 3.3)", fitted(curve.gamma1)},
                    {"γ2 [N m]", "0.5586 (Table 3.3)", fitted(curve.gamma2)},
                    {"γ3 [N m s/rad]", "0.0356 (Table 3.3)", fitted(curve.gamma3)}};
  return figure;
}

/// Ten runs differ by the noise of the torque alone, which stands for all that does not repeat.
Figure figure_repeated(const Run& log) {
  constexpr int runs = 10;
  constexpr double noise = 0.005;  // N m
  Panel whole{"ten runs at 1 rad/s", "output angle [rad]", "torque [N m]", {}},
      near{"three turns of the motor", "output angle [rad]", "torque [N m]", {}};
  std::mt19937_64 random(7);
  std::normal_distribution<double> unit;
  const auto from = static_cast<long>(2.0 / log.period()),
             turns = static_cast<long>(6.0 * pi * 0.01 / log.period());
  for (int k = 0; k < runs; ++k) {
    Eigen::ArrayXd torque = log.torque;
    for (double& each : torque) each += noise * unit(random);
    const long skip = log.time.size() / 6;
    whole.series.push_back(
        line("", log.theta.tail(log.theta.size() - skip), torque.tail(torque.size() - skip), 5));
    near.series.push_back(line("", log.theta.segment(from, turns), torque.segment(from, turns)));
  }
  Figure figure{
      "figure_3_04", "3.4", "Torque at constant velocity, repeated (simulated)", "", {whole, near}};
  figure.differs = fmt::format(
      "{}One simulated run with ten different noises of {} N m: a simulation repeats exactly, so "
      "that the figure shows how it would look, and is no evidence that the motor repeats.",
      simulated, noise);
  figure.numbers = {{"ten runs started at the same motor position",
                     "strongly repeatable; no number is printed",
                     fmt::format("the same but for {} N m of noise, by construction", noise)}};
  return figure;
}

/// Amplitude of a signal by frequency, with a Hann window, from 1 Hz to 40 Hz.
Series spectrum(const std::string& title, const Eigen::ArrayXd& signal, double period) {
  const long n = signal.size();
  const Eigen::ArrayXd at = Eigen::ArrayXd::LinSpaced(n, 0.0, static_cast<double>(n - 1));
  const Eigen::ArrayXd window = 0.5 - 0.5 * (at * (2.0 * pi / static_cast<double>(n))).cos();
  const Eigen::ArrayXd weighed = (signal - signal.mean()) * window;
  const double step = 0.5 / (static_cast<double>(n) * period);
  Series series{title, {}, {}};
  for (double f = 1.0; f <= 40.0; f += step) {
    const Eigen::ArrayXd angle = at * (2.0 * pi * f * period);
    series.x.push_back(f);
    series.y.push_back(2.0 *
                       std::hypot((weighed * angle.cos()).sum(), (weighed * angle.sin()).sum()) /
                       window.sum());
  }
  return series;
}

double peak(const Series& spectrum) {
  return *std::max_element(spectrum.y.begin(), spectrum.y.end());
}

double peak_frequency(const Series& spectrum) {
  const auto at = std::max_element(spectrum.y.begin(), spectrum.y.end()) - spectrum.y.begin();
  return spectrum.x[static_cast<std::size_t>(at)];
}

/// The part of a run after the transient at its beginning.
Run settled(const Run& log) {
  const long n = log.time.size() - log.time.size() / 6;
  return {log.time.tail(n), log.theta.tail(n), log.omega.tail(n), log.torque.tail(n),
          log.reference.tail(n)};
}

Figure figure_two_velocities(const Run& fast, const Run& slow) {
  Panel torque{"torque over position", "output angle [rad]", "torque [N m]", {}};
  const auto part = [](const Run& log, const std::string& title) {
    // Half a radian that both pass.
    long from = 0, to = 0;
    while (log.theta(from) < 3.0) ++from;
    for (to = from; log.theta(to) < 3.5;) ++to;
    return line(title, log.theta.segment(from, to - from), log.torque.segment(from, to - from));
  };
  torque.series = {part(fast, "1 rad/s"), part(slow, "0.5 rad/s")};
  Panel frequencies{"spectrum", "frequency [Hz]", "torque [N m]", {}};
  frequencies.series = {spectrum("1 rad/s", fast.torque, fast.period()),
                        spectrum("0.5 rad/s", slow.torque, slow.period())};
  Figure figure{
      "figure_3_05", "3.5", "Torque at two velocities (simulated)", "", {torque, frequencies}};
  figure.differs =
      std::string(simulated) +
      "The peak moves with the velocity (15.9 Hz and 8.0 Hz, the motor's turns) while the ripple "
      "stays where it is over the position.";
  figure.numbers = {
      {"main frequency at 1 rad/s", "the motor's rotation frequency (100/2π = 15.9 Hz)",
       fmt::format("{:.1f} Hz", peak_frequency(frequencies.series[0]))},
      {"main frequency at 0.5 rad/s", "the motor's rotation frequency (8.0 Hz)",
       fmt::format("{:.1f} Hz", peak_frequency(frequencies.series[1]))}};
  return figure;
}

/// What the controller commands: before the compensation is added.
Run controlled(const Run& log, const CompiledModel& motor) {
  Run result = log;
  for (long i = 0; i < log.time.size(); ++i)
    result.torque(i) -= motor("compensation_torque", {log.theta(i), log.omega(i)})[0];
  return result;
}

Figure figure_compensation(const Run& before, const Run& after) {
  Panel time{"controller's torque", "time [s]", "torque [N m]", {}};
  const auto second = [](const Run& log, const std::string& title) {
    const auto from = static_cast<long>(1.0 / log.period()), n = from / 2;
    return line(title, log.time.segment(from, n), log.torque.segment(from, n));
  };
  time.series = {second(before, "without compensation"), second(after, "with compensation")};
  Panel frequencies{"spectrum", "frequency [Hz]", "torque [N m]", {}};
  frequencies.series = {spectrum("without compensation", before.torque, before.period()),
                        spectrum("with compensation", after.torque, after.period())};
  const double first = peak(frequencies.series[0]), second_peak = peak(frequencies.series[1]);
  Figure figure{"figure_3_06",
                "3.6",
                "Controller's torque before and after compensation (simulated)",
                "",
                {time, frequencies}};
  figure.differs = fmt::format(
      "{}At the motor's rotation frequency the amplitude falls from {:.3g} N m to {:.3g} N m: the "
      "feedforward carries 0.9 of the friction and ripple that it knows exactly here. On a motor "
      "it knows them as well as they were identified.",
      simulated, first, second_peak);
  figure.numbers = {{"amplitude at the motor's rotation frequency", "reduced; no number is printed",
                     fmt::format("{:.3g} N m, with compensation {:.3g} N m", first, second_peak)}};
  return figure;
}

}  // namespace

std::vector<Figure> figures_motor(const fs::path& model, const CompiledModel& emitted,
                                  const fs::path& runtime) {
  const Part part = read_part(model);
  const auto* motor = std::get_if<MotorParameters>(&part.parameters);
  if (!motor) throw std::runtime_error((model / "part.toml").string() + ": describes no motor");
  const Run friction = run(model, "friction", runtime),
            fast = run(model, "constant_velocity", runtime),
            slow = run(model, "slow_velocity", runtime),
            compensated = run(model, "compensated_velocity", runtime);
  return {figure_friction(friction, motor->gear_ratio), figure_repeated(fast),
          figure_two_velocities(settled(fast), settled(slow)),
          figure_compensation(settled(fast), controlled(settled(compensated), emitted))};
}

}  // namespace sinew

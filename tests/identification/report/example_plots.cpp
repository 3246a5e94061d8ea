// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/identification/report/example_plots.h"

#include <cmath>

namespace sinew::diagnosis::example {
namespace {

/// Coloured noise that is the same everywhere.
class Noise {
 public:
  explicit Noise(unsigned seed) : state_(seed * 2654435761U + 1U) {}
  double operator()() {
    state_ = state_ * 1664525U + 1013904223U;
    value_ = 0.8 * value_ + 0.6 * (static_cast<double>(state_ >> 8) / 16777216.0 - 0.5);
    return value_;
  }

 private:
  unsigned state_;
  double value_ = 0.0;
};

struct Sample {
  double time, position, velocity, effort, before, after;
};

std::vector<Sample> motion(int samples, unsigned seed) {
  Noise noise(seed);
  std::vector<Sample> result;
  for (int i = 0; i < samples; ++i) {
    const double t = 24.0 * i / samples;
    const double position = 0.12 * std::sin(0.7 * t) + 0.03 * std::sin(2.3 * t);
    const double velocity = 0.084 * std::cos(0.7 * t) + 0.069 * std::cos(2.3 * t);
    const double after = 1.4 * noise();
    const double before = after + 4.5 * std::atan(velocity / 0.03) - 14.0 * std::abs(velocity) +
                          1.6 * std::sin(157.0 * position);
    result.push_back({t, position, velocity, 40.0 * std::cos(2.3 * t) + before, before, after});
  }
  return result;
}

Series series_of(const std::string& label, const std::vector<Sample>& samples, double Sample::*x,
                 double Sample::*y, bool points) {
  Series series{label, {}, {}, points};
  for (const Sample& s : samples) {
    series.x.push_back(s.*x);
    series.y.push_back(s.*y);
  }
  return series;
}

Plot residual_plot(const std::vector<Sample>& samples, double Sample::*x, bool points, bool after) {
  Plot plot;
  plot.series.push_back(
      series_of(after ? "residual before" : "residual", samples, x, &Sample::before, points));
  if (after) plot.series.push_back(series_of("residual after", samples, x, &Sample::after, points));
  return plot;
}

Series spectrum(const std::string& label, double level, double line) {
  Series series{label, {}, {}, false};
  for (int i = 1; i <= 4000; ++i) {
    const double f = 0.05 * i;
    const double wiggle = 1.0 + 0.5 * std::sin(7.1 * i) * std::sin(0.37 * i);
    series.x.push_back(f);
    series.y.push_back(level * wiggle / (1.0 + f * f / 90.0) +
                       line * std::exp(-std::pow((f - 12.4) / 0.3, 2)));
  }
  return series;
}

}  // namespace

std::vector<Plot> drive_plots(const std::string& channel, const std::string& unit, int samples,
                              unsigned seed, bool after) {
  const std::vector<Sample> all = motion(samples, seed);
  const std::string residual = "residual of " + channel + " [" + unit + "]";
  std::vector<Plot> plots;
  const auto add = [&](Plot plot, const char* kind, const char* title, const char* x,
                       const std::string& y, const char* caption) {
    plot.kind = kind;
    plot.title = title;
    plot.x_label = x;
    plot.y_label = y;
    plot.caption = caption;
    plots.push_back(plot);
  };
  add(residual_plot(all, &Sample::velocity, true, after), "velocity", "residual against velocity",
      "velocity [m/s]", residual,
      "Bends towards a plateau and leans: friction concave in speed, more one way than the other.");
  add(residual_plot(all, &Sample::position, true, after), "position", "residual over the position",
      "position [m]", residual, "A ripple once per motor turn.");
  Plot time = residual_plot(all, &Sample::time, false, after);
  add(time, "time", "residual over time", "time [s]", residual,
      "Repeats with the motion before; noise after.");
  Plot measured;
  measured.series = {series_of("measured", all, &Sample::time, &Sample::effort, false)};
  Series model = measured.series[0];
  model.label = "model before";
  for (std::size_t i = 0; i < all.size(); ++i) model.y[i] -= all[i].before;
  measured.series.push_back(model);
  if (after) {
    model.label = "model after";
    for (std::size_t i = 0; i < all.size(); ++i) model.y[i] += all[i].before - all[i].after;
    measured.series.push_back(model);
  }
  add(measured, "loop", "measured and predicted", "time [s]", channel + " [" + unit + "]", "");
  Plot lines;
  lines.logarithmic = true;
  lines.series = {spectrum(after ? "residual before" : "residual", 2e-2, 0.9)};
  if (after) lines.series.push_back(spectrum("residual after", 6e-3, 0.0));
  lines.series.push_back(spectrum("noise floor", 4e-3, 0.0));
  add(lines, "spectrum", "spectrum of the residual", "frequency [Hz]",
      "power density [(" + unit + ")^2/Hz]", "The line at 12.4 Hz goes, and the low end drops.");
  return plots;
}

}  // namespace sinew::diagnosis::example

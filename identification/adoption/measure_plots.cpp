// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/adoption/measure_plots.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>

#include "identification/regression/spectrum.h"

namespace sinew::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

using Abscissa = std::function<const VectorXd&(const MeasuredChannel&)>;

std::vector<double> list(const VectorXd& x) {
  return {x.data(), x.data() + x.size()};
}

/// Mean of the residual in `bins` slices of equal width, per direction of motion.
Series binned(const std::vector<const MeasuredChannel*>& logs, const Abscissa& abscissa, bool after,
              int direction, const std::string& label) {
  constexpr int bins = 60;
  double low = 1e300, high = -1e300;
  for (const MeasuredChannel* m : logs) {
    low = std::min(low, abscissa(*m).minCoeff());
    high = std::max(high, abscissa(*m).maxCoeff());
  }
  std::vector<double> sum(bins, 0.0), count(bins, 0.0);
  for (const MeasuredChannel* m : logs) {
    const VectorXd left = m->measured - (after ? m->after : m->before);
    const VectorXd& x = abscissa(*m);
    for (Index k = 0; k < x.size(); ++k) {
      if (direction != 0 && m->velocity(k) * direction <= 0.0) continue;
      const auto b = static_cast<std::size_t>(
          std::clamp((x(k) - low) / std::max(high - low, 1e-300) * bins, 0.0, bins - 1.0));
      sum[b] += left(k);
      count[b] += 1.0;
    }
  }
  Series series{label, {}, {}, false};
  for (int b = 0; b < bins; ++b) {
    const auto i = static_cast<std::size_t>(b);
    if (count[i] < 5.0) continue;
    series.x.push_back(low + (b + 0.5) * (high - low) / bins);
    series.y.push_back(sum[i] / count[i]);
  }
  return series;
}

Plot dependence(const std::vector<const MeasuredChannel*>& logs, const std::string& kind,
                const std::string& title, const std::string& x_label, const std::string& y_label,
                const std::string& caption, const Abscissa& abscissa, bool by_direction) {
  Plot plot{kind, title, x_label, y_label, caption, false, {}};
  if (by_direction) {
    plot.series.push_back(binned(logs, abscissa, false, +1, "before, forwards"));
    plot.series.push_back(binned(logs, abscissa, false, -1, "before, backwards"));
    plot.series.push_back(binned(logs, abscissa, true, +1, "after, forwards"));
    plot.series.push_back(binned(logs, abscissa, true, -1, "after, backwards"));
  } else {
    plot.series.push_back(binned(logs, abscissa, false, 0, "before"));
    plot.series.push_back(binned(logs, abscissa, true, 0, "after"));
  }
  return plot;
}

/// Amplitude density of the residual, smoothed over 6 % of the frequency.
Series spectrum_of(const MeasuredChannel& m, bool after, const std::string& label) {
  VectorXd left = m.measured - (after ? m.after : m.before);
  left.array() -= left.mean();
  const Index even = left.size() / 2 * 2;
  const VectorXd energy = bin_energy(to_band(left.head(even), even / 2));
  Series series{label, {}, {}, false};
  const double width = 1.0 / (m.step * static_cast<double>(even));
  for (double from = 1.0; from < static_cast<double>(energy.size()); from *= 1.06) {
    const auto first = static_cast<Index>(from);
    const Index last =
        std::min<Index>(energy.size(), std::max(first + 1, static_cast<Index>(from * 1.06)));
    const double mean = energy.segment(first, last - first).mean() / static_cast<double>(even);
    series.x.push_back(width * 0.5 * static_cast<double>(first + last - 1));
    series.y.push_back(std::sqrt(mean / width));
  }
  return series;
}

}  // namespace

std::vector<Plot> channel_plots(const std::vector<MeasuredChannel>& measured, int channel,
                                bool held_out, bool revolute) {
  const std::string unit = revolute ? "N m" : "N";
  return channel_plots(measured, channel, held_out,
                       {"effort", unit, "position", revolute ? "rad" : "m", unit});
}

std::vector<Plot> channel_plots(const std::vector<MeasuredChannel>& measured, int channel,
                                bool held_out, const PlotNames& names) {
  std::vector<const MeasuredChannel*> logs;
  for (const MeasuredChannel& m : measured)
    if (m.channel == channel && m.held_out == held_out && m.measured.size() > 100)
      logs.push_back(&m);
  if (logs.empty()) return {};
  const MeasuredChannel& first = *logs.front();
  const std::string effort = names.quantity + " [" + names.unit + "]";
  const std::string left = "residual [" + names.unit + "]";
  const std::string length = names.position_unit;
  const std::string capital = {static_cast<char>(std::toupper(names.quantity.front()))};
  const std::string quantity = capital + names.quantity.substr(1);
  std::vector<Plot> plots;
  plots.push_back({"time",
                   "Measured and modelled " + names.quantity,
                   "time [s]",
                   effort,
                   "How well the model follows the measurement.",
                   false,
                   {{"measured", list(first.time), list(first.measured), false},
                    {"model before", list(first.time), list(first.before), false},
                    {"model after", list(first.time), list(first.after), false}}});
  plots.push_back({"time",
                   "Residual",
                   "time [s]",
                   left,
                   "Measured minus modelled: a good model leaves noise.",
                   false,
                   {{"before", list(first.time), list(first.measured - first.before), false},
                    {"after", list(first.time), list(first.measured - first.after), false}}});
  plots.push_back(dependence(
      logs, "velocity", "Residual against the velocity", "velocity [" + length + "/s]", left,
      "Friction that the model lacks shows here; flat is good.",
      [](const MeasuredChannel& m) -> const VectorXd& { return m.velocity; }, false));
  plots.push_back(dependence(
      logs, "position", "Residual against the " + names.position,
      names.position + " [" + length + "]", left,
      "Ripple, springs and gravity show the same curve both ways; friction shows two.",
      [](const MeasuredChannel& m) -> const VectorXd& { return m.position; }, true));
  if (first.load.size() > 0)
    plots.push_back(dependence(
        logs, "load", "Residual against the load", "load [" + names.load_unit + "]", left,
        "Friction that grows with the load opens a wedge between the directions.",
        [](const MeasuredChannel& m) -> const VectorXd& { return m.load; }, true));
  plots.push_back({"spectrum",
                   "Spectrum of the residual",
                   "frequency [Hz]",
                   "residual [" + names.unit + "/√Hz]",
                   "Where over the frequency the extension helps.",
                   true,
                   {spectrum_of(first, false, "before"), spectrum_of(first, true, "after")}});
  plots.push_back({"loop",
                   quantity + " against the " + names.position,
                   names.position + " [" + length + "]",
                   effort,
                   "The width of the loop is friction, its slope a spring.",
                   false,
                   {{"measured", list(first.position), list(first.measured), false},
                    {"model after", list(first.position), list(first.after), false}}});
  return plots;
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/report/figures.h"
#include "identification/report/numbers.h"
#include "identification/report/page.h"
#include "identification/report/sections.h"
#include "identification/report/wording.h"

namespace sinew::diagnosis {
namespace {

std::string coloured(const char* role, const std::string& text) {
  return fmt::format("<span class=\"{}\">{}</span>", role, text);
}

std::string change_of(const Gain& gain) {
  return shown_share(gain.share) + " <span class=\"soft\">(" + shown_interval(gain) + ")</span>";
}

/// Where no cause was named there is no model after.
Table domain_table(const Findings& findings) {
  const bool changed = !findings.verdict.causes.empty();
  std::vector<std::string> headings = {"Channel", "Domain", changed ? "#Error before" : "#Error"};
  if (changed)
    headings.insert(headings.end(),
                    {"#Error after", "#" + capitalised(extension_gain_name(findings))});
  Table table(headings, "Root mean square error on " + judged_logs(findings) +
                            (changed ? ", with the 95 % interval of the gain." : "."));
  for (const ChannelFinding& channel : findings.channels)
    for (const DomainError& error : channel.domains)
      table.row({escaped_name(channel.name), escaped(error.domain),
                 coloured("before", escaped(shown_quantity(error.before, error.unit))),
                 coloured("after", escaped(shown_quantity(error.after, error.unit))),
                 change_of(error.gain)});
  return table;
}

double worst_relative_error(const Findings& findings) {
  double worst = 1e-12;
  for (const ChannelFinding& c : findings.channels)
    for (const DomainError& first : c.domains) {
      for (const double error : {c.relative(first.before), c.relative(first.after)})
        if (std::isfinite(error)) worst = std::max(worst, error);
      break;
    }
  return worst;
}

std::string unexplained_of(const ChannelFinding& channel, bool changed) {
  if (channel.nothing_to_explain())
    return "nothing to explain <span class=\"soft\">(error below " +
           escaped(shown_quantity(channel.material_error(), channel.unit)) + ")</span>";
  const std::string before = coloured("before", shown_share(channel.unexplained_before));
  return changed ? before + " → " + coloured("after", shown_share(channel.unexplained_after))
                 : before;
}

/// Bars are measured against the worst channel.
Table variance_table(const Findings& findings) {
  const bool changed = !findings.verdict.causes.empty();
  std::vector<std::string> headings = {"Channel", "#Standard deviation", "#Noise floor",
                                       changed ? "#Relative error before" : "#Relative error"};
  if (changed) headings.push_back("#Relative error after");
  headings.push_back("#Variance unexplained");
  Table table(
      headings,
      "Relative error: rms error / standard deviation of the channel. Variance unexplained: "
      "mean square error / variance of the channel, 100 % at most. There is nothing to "
      "explain where the rms error is below " +
          shown_share(findings.channels.empty() ? Settings{}.material_share
                                                : findings.channels.front().material_share) +
          " of the channel's rms, or below what rounding to the log's steps makes.");
  const double worst = worst_relative_error(findings);
  const auto cell = [&](double error, const char* role) {
    return coloured(role, shown_percent(error)) + (changed ? bar(error / worst, role) : "");
  };
  for (const ChannelFinding& c : findings.channels) {
    if (c.domains.empty()) continue;
    std::vector<std::string> cells = {escaped_name(c.name),
                                      escaped(shown_quantity(c.standard_deviation, c.unit)),
                                      escaped(shown_quantity(c.noise_floor, c.unit)),
                                      cell(c.relative(c.domains.front().before), "before")};
    if (changed) cells.push_back(cell(c.relative(c.domains.front().after), "after"));
    cells.push_back(unexplained_of(c, changed));
    table.row(cells);
  }
  return table;
}

std::string alternative_of(const Plot& plot) {
  std::string text = plot.title + ": " + plot.y_label + " over " + plot.x_label + ".";
  std::string labels;
  for (const Series& series : plot.series) labels += (labels.empty() ? "" : ", ") + series.label;
  if (!labels.empty()) text += " Shown: " + labels + ".";
  return plot.caption.empty() ? text : text + " " + plot.caption;
}

std::string key_of(const Plot& plot) {
  if (plot.series.empty()) return "";
  std::string text;
  for (std::size_t k = 0; k < plot.series.size(); ++k) {
    const Series& series = plot.series[k];
    const std::string role = series_role(series.label, k);
    const char* shape = series.points             ? "points"
                        : is_dashed(series.label) ? "dashed"
                        : role == "noise"         ? "dotted"
                                                  : "solid";
    text += fmt::format("<li><i class=\"{}\" style=\"color:var(--{})\"></i>{}</li>", shape, role,
                        escaped(series.label));
  }
  return "<ul class=\"key\">" + text + "</ul>";
}

std::string figure_of(const Plot& plot, const std::string& svg) {
  const bool samples = std::any_of(plot.series.begin(), plot.series.end(),
                                   [](const Series& s) { return !s.x.empty() && !s.y.empty(); });
  const char* absent =
      samples
          ? "<p class=\"absent\">This picture is drawn by gnuplot (Debian: gnuplot-nox), which was "
            "not there when the report was written. findings.json has its numbers.</p>"
          : "<p class=\"absent\">The logs have no samples for this plot.</p>";
  return "<figure><figcaption><h4>" + escaped(capitalised(plot.title)) + "</h4>" +
         (plot.caption.empty() ? "" : "<span class=\"soft\">" + escaped(plot.caption) + "</span>") +
         "</figcaption>\n" + (svg.empty() ? absent : svg) + key_of(plot) + "</figure>\n";
}

double largest_of(const Plot& plot, std::vector<double> Series::*coordinates) {
  double largest = 0.0;
  for (const Series& series : plot.series)
    for (const double value : series.*coordinates)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return largest;
}

/// An axis in the unit that suits its values; where powers of ten are its ticks, in the label's
/// own.
void set_axis(Plot& plot, std::string& label, std::vector<double> Series::*coordinates) {
  const std::size_t open = label.rfind('['), close = label.rfind(']');
  const bool stated = open != std::string::npos && close != std::string::npos && open < close;
  const std::string unit = stated ? label.substr(open + 1, close - open - 1) : "1";
  const AxisUnit axis = plot.logarithmic ? AxisUnit{1.0, shown_unit(unit)}
                                         : axis_unit(largest_of(plot, coordinates), unit);
  const std::string shown = axis.unit.empty() ? "" : "[" + axis.unit + "]";
  label = stated ? label.substr(0, open) + shown + label.substr(close + 1)
                 : label + (shown.empty() ? "" : " " + shown);
  if (axis.factor == 1.0) return;
  for (Series& series : plot.series)
    for (double& value : series.*coordinates) value *= axis.factor;
}

Plot with_shown_units(Plot plot) {
  set_axis(plot, plot.x_label, &Series::x);
  set_axis(plot, plot.y_label, &Series::y);
  return plot;
}

std::string figures(const Findings& findings) {
  std::vector<Plot> plots;
  std::vector<std::string> alternatives;
  for (const ChannelFinding& channel : findings.channels)
    for (const Plot& plot : channel.plots) {
      plots.push_back(with_shown_units(plot));
      alternatives.push_back(alternative_of(plots.back()));
    }
  const std::vector<std::string> drawn = svg_figures(plots, alternatives);
  std::string text;
  std::size_t next = 0, opened = 0;
  for (const ChannelFinding& channel : findings.channels) {
    if (channel.plots.empty()) continue;
    std::string content;
    for (std::size_t k = 0; k < channel.plots.size(); ++k, ++next)
      content += figure_of(plots[next], drawn[next]);
    content = "<div class=\"figures\">\n" + content + "</div>\n";
    // The first channels carry the verdict; more would be a wall of plots.
    text += findings.channels.size() == 1
                ? content
                : folded(channel.name +
                             (channel.unit.empty() ? "" : " [" + shown_unit(channel.unit) + "]"),
                         content, opened++ < 2);
  }
  return text;
}

}  // namespace

std::string channel_section(const Findings& findings) {
  if (findings.channels.empty()) return "";
  std::string content;
  const Table domains = domain_table(findings);
  if (!domains.empty()) content += domains.html();
  const Table variances = variance_table(findings);
  if (!variances.empty()) content += variances.html();
  return section("channels", "Before and after, channel by channel", content) +
         section("pictures", "What it looks like", figures(findings));
}

}  // namespace sinew::diagnosis

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/report/report_figures.h"
#include "identification/report/report_numbers.h"
#include "identification/report/report_page.h"
#include "identification/report/report_sections.h"
#include "identification/report/report_wording.h"

namespace sinew::diagnosis {
namespace {

std::string coloured(const char* role, const std::string& text) {
  return fmt::format("<span class=\"{}\">{}</span>", role, text);
}

std::string change_of(const Gain& gain) {
  return shown_share(gain.share) + " <span class=\"soft\">(" + shown_interval(gain) + ")</span>";
}

std::string where_of(const Findings& findings) {
  return has_held_out(findings) ? measured_on(findings) : "the training logs";
}

/// Where no cause was named there is no model after.
Table domain_table(const Findings& findings) {
  const bool changed = !findings.verdict.causes.empty();
  std::vector<std::string> headings = {"Channel", "Seen as", changed ? "#Error before" : "#Error"};
  if (changed) headings.insert(headings.end(), {"#Error after", "#Squared error that goes away"});
  Table table(headings, "Root mean square error on " + where_of(findings) +
                            (changed ? ", with the 95 % interval of the gain." : "."));
  for (const ChannelFinding& channel : findings.channels)
    for (const DomainError& error : channel.domains)
      table.row({escaped_name(channel.name), escaped(error.domain),
                 coloured("before", escaped(shown_quantity(error.before, error.unit))),
                 coloured("after", escaped(shown_quantity(error.after, error.unit))),
                 change_of(error.gain)});
  return table;
}

double worst_share(const Findings& findings) {
  double worst = 1e-12;
  for (const ChannelFinding& c : findings.channels)
    for (const double share : {c.unexplained_before, c.unexplained_after})
      if (std::isfinite(share)) worst = std::max(worst, share);
  return worst;
}

/// Bars are measured against the worst channel.
Table noise_table(const Findings& findings) {
  const bool changed = !findings.verdict.causes.empty();
  std::vector<std::string> headings = {"Channel", "#Measured (rms)", "#Noise floor",
                                       changed ? "#Unexplained before" : "#Unexplained"};
  if (changed) headings.push_back("#Unexplained after");
  Table table(headings,
              "Share of each channel's variance that the model does not explain, beside the noise "
              "that no model can explain.");
  const double worst = worst_share(findings);
  const auto share = [&](double value, const char* role) {
    return coloured(role, shown_share(value)) + (changed ? bar(value / worst, role) : "");
  };
  for (const ChannelFinding& c : findings.channels)
    table.row({escaped_name(c.name), escaped(shown_quantity(c.measured_rms, c.unit)),
               escaped(shown_quantity(c.noise_floor, c.unit)),
               share(c.unexplained_before, "before"), share(c.unexplained_after, "after")});
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
          : "<p class=\"absent\">The logs have no samples for this picture.</p>";
  return "<figure><figcaption><h4>" + escaped(capitalised(plot.title)) + "</h4>" +
         (plot.caption.empty() ? "" : "<span class=\"soft\">" + escaped(plot.caption) + "</span>") +
         "</figcaption>\n" + (svg.empty() ? absent : svg) + key_of(plot) + "</figure>\n";
}

Plot with_shown_units(Plot plot) {
  for (std::string* label : {&plot.x_label, &plot.y_label}) {
    const std::size_t open = label->rfind('['), close = label->rfind(']');
    if (open == std::string::npos || close == std::string::npos || close < open) continue;
    const std::string unit = shown_unit(label->substr(open + 1, close - open - 1));
    *label =
        label->substr(0, open) + (unit.empty() ? "" : "[" + unit + "]") + label->substr(close + 1);
  }
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
    // The first channels carry the verdict; more would be a wall of pictures.
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
  content += noise_table(findings).html();
  return section("channels", "Before and after, channel by channel", content) +
         section("pictures", "What it looks like", figures(findings));
}

}  // namespace sinew::diagnosis

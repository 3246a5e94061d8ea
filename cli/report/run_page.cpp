// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/run_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "cli/report/page_shell.h"
#include "identification/report/page.h"

namespace sinew {
namespace {

using diagnosis::escaped;
using diagnosis::escaped_name;

struct Channel {
  std::string name, unit;
};

Channel channel_of(const std::string& column) {
  const std::size_t at = column.rfind(" [");
  if (at == std::string::npos) return {column, ""};
  return {column.substr(0, at), column.substr(at + 2, column.size() - at - 3)};
}

/// Column without the time, from 0; -1 where there is none.
int column_named(const RecordedRun& run, const std::string& name) {
  for (std::size_t k = run.columns().size(); k-- > 1;)
    if (channel_of(run.columns()[k]).name == name) return static_cast<int>(k) - 1;
  return -1;
}

/// What a channel measures, by its name and unit.
std::string quantity_of(const Channel& channel) {
  const auto begins = [&](const char* with) { return channel.name.rfind(with, 0) == 0; };
  if (begins("qd_")) return "Velocities of joints";
  if (begins("theta_ref")) return "Commanded angles of motors";
  if (begins("theta")) return "Angles of motors";
  if (begins("omega")) return "Speeds of motors";
  if (begins("force_")) return "Tendon forces";
  if (begins("lever")) return "Angles of levers";
  if (begins("load")) return "Load";
  if (begins("tau")) return "Torques";
  if (channel.name == "q71" || channel.name == "q73") return "Bar angles of the wrist";
  return channel.unit == "m" ? "Positions of joints that slide" : "Positions of joints";
}

struct ChannelGroup {
  std::string title, unit, id;
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
};

std::vector<ChannelGroup> groups_of(const RecordedRun& run) {
  std::vector<ChannelGroup> groups;
  for (std::size_t k = 1; k < run.columns().size(); ++k) {
    const Channel channel = channel_of(run.columns()[k]);
    const std::string title = quantity_of(channel);
    if (groups.empty() || groups.back().title != title || groups.back().unit != channel.unit)
      groups.push_back({title, channel.unit, fmt::format("channels-{}", groups.size()),
                        nlohmann::ordered_json::array()});
    groups.back().columns.push_back({channel.name, k - 1});
  }
  return groups;
}

/// Columns of the drawing's coordinates, in their order: the first ones, and the wrist's.
nlohmann::ordered_json coordinate_columns(const RunReport& report) {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  if (!report.model.drawing) return columns;
  const DrawnScene& drawing = *report.model.drawing;
  const std::size_t own = drawing.coordinates.size() - drawing.palm.size();
  for (std::size_t k = 0; k < own; ++k) columns.push_back(k);
  for (std::size_t k = 0; k < drawing.palm.size(); ++k)
    columns.push_back(column_named(report.run, k == 0 ? "q71" : "q73"));
  return columns;
}

nlohmann::ordered_json force_columns(const RunReport& report) {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  if (!report.model.drawing) return columns;
  for (std::size_t i = 0; i < report.model.drawing->scene["tendons"].size(); ++i) {
    const int column = column_named(report.run, fmt::format("force_{}", i + 1));
    if (column < 0) return nlohmann::ordered_json::array();
    columns.push_back(column);
  }
  return columns;
}

std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

double size_of(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

nlohmann::ordered_json energy_plots(const RunReport& report) {
  nlohmann::ordered_json plots = nlohmann::ordered_json::array();
  if (report.books.time.size() < 2) return plots;
  nlohmann::ordered_json series =
      nlohmann::ordered_json::array({{{"name", "energy"}, {"y", report.books.energy}}});
  plots.push_back({{"title", "Energy"},
                   {"yLabel", "kinetic, of gravity, in levers and tendons [J]"},
                   {"series", series}});
  series = nlohmann::ordered_json::array();
  double most = size_of(report.books.energy);
  for (std::size_t i = 0; i < report.books.work.size(); ++i) {
    most = std::max(most, size_of(report.books.work[i]));
    if (size_of(report.books.work[i]) > 0.0)
      series.push_back(
          {{"name", spoken(report.powers.at(i))}, {"key", true}, {"y", report.books.work[i]}});
  }
  if (!series.empty())
    plots.push_back({{"title", "Work since the start"},
                     {"yLabel", "losses are negative [J]"},
                     {"series", series}});
  plots.push_back(
      {{"title", "What the books miss"},
       {"yLabel", "energy less its start and all work [J]"},
       {"note", fmt::format("At most {} of the largest energy or work: the integrator’s error and "
                            "rounding.",
                            shown(most > 0.0 ? size_of(report.books.missing) / most : 0.0))},
       {"series",
        nlohmann::ordered_json::array({{{"name", "missing"}, {"y", report.books.missing}}})}});
  return plots;
}

nlohmann::ordered_json run_json(const RunReport& report, const std::vector<ChannelGroup>& groups) {
  nlohmann::ordered_json run{
      {"instants", report.run.instants()},    {"times", report.run.packed_times()},
      {"packed", report.run.packed_values()}, {"coordinates", coordinate_columns(report)},
      {"forces", force_columns(report)},      {"slackBelow", 1e-9},
      {"energyTime", report.books.time},      {"energy", energy_plots(report)}};
  run["groups"] = nlohmann::ordered_json::array();
  for (const ChannelGroup& group : groups)
    run["groups"].push_back({{"id", group.id},
                             {"title", group.title},
                             {"unit", group.unit},
                             {"columns", group.columns}});
  run["slack"] = nlohmann::ordered_json::array();
  for (const SlackSpan& span : report.slack)
    run["slack"].push_back(nlohmann::ordered_json::array({span.tendon, span.from, span.to}));
  return run;
}

std::string slack_words(const RunReport& report) {
  if (!report.knows_slack) return "";
  std::set<std::string> tendons;
  for (const SlackSpan& span : report.slack) tendons.insert(span.tendon);
  return tendons.empty()
             ? "; no tendon went slack"
             : fmt::format("; {} went slack", counted(tendons.size(), "tendon", "tendons"));
}

std::string run_headline(const RunReport& report) {
  double most = size_of(report.books.energy);
  for (const std::vector<double>& work : report.books.work) most = std::max(most, size_of(work));
  std::string text =
      fmt::format("{}: {} s simulated", report.model.emitted.name, shown(report.duration));
  if (most > 0.0)
    text += fmt::format("; the energy books close to {} J of {} J",
                        shown(size_of(report.books.missing)), shown(most));
  return text + slack_words(report);
}

std::string run_controls(const RunReport& report) {
  std::string text = fmt::format(
      "<div class=\"buttons\"><button id=\"play\" type=\"button\">Play</button><label "
      "for=\"speed\" class=\"choose\" style=\"margin:0\">Speed <select id=\"speed\"><option "
      "value=\"0.1\">a tenth</option><option value=\"0.25\">a quarter</option><option value=\"1\" "
      "selected>as it was</option></select></label></div>\n<div class=\"slider\"><label "
      "for=\"time\">Time</label><input type=\"range\" id=\"time\" min=\"0\" max=\"{0:g}\" "
      "step=\"{1:g}\" value=\"0\"><output for=\"time\" id=\"time-told\"></output></div>\n"
      "<dl id=\"readout\" class=\"facts\"></dl>\n",
      report.duration, report.duration / 1000.0);
  text += "<dl class=\"facts\">";
  for (const auto& [name, value] : report.facts)
    text += "<div><dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd></div>\n";
  return text + "</dl>\n";
}

std::string slack_section(const RunReport& report) {
  if (!report.knows_slack) return "";
  return diagnosis::section("slack", "Slack",
                            report.slack.empty()
                                ? "<p>Every tendon was under tension all the time.</p>\n"
                                : "<div id=\"slack-plot\" class=\"figures drawn\"></div>\n");
}

std::string channel_section(const RunReport& report, const std::vector<ChannelGroup>& groups) {
  std::string text = fmt::format(
      "<p>Every channel of the log, in {} instants of {} ms; what a channel does within one is the "
      "band around its line. The log itself has all rows.</p>\n",
      report.run.instants(), shown(1000.0 * report.duration / 400.0));
  bool open = true;
  for (const ChannelGroup& group : groups) {
    const std::string inside = "<div class=\"figures drawn\"></div>";
    text += fmt::format(
        "<details id=\"{}\"{}><summary>{} [{}], {}</summary><div "
        "class=\"inside\">{}</div></details>\n",
        group.id, open ? " open" : "", escaped(group.title), escaped(group.unit),
        counted(group.columns.size(), "channel", "channels"), inside);
    open = false;
  }
  return diagnosis::section("channels", "Channels", text);
}

}  // namespace

std::string run_page(const RunReport& report) {
  std::vector<std::string> left_out;
  ModelReport model = report.model;
  model.emitted.functions.clear();  // forces are the run's; poses are the drawing's own functions
  model.coupling = force_columns(report).empty() ? "" : "coupling_matrix";  // for the colours' key
  const std::vector<Graph> graphs = functions_of_page(model, left_out);
  const std::vector<ChannelGroup> groups = groups_of(report.run);
  nlohmann::ordered_json data = data_of(model, graphs);
  data["run"] = run_json(report, groups);
  const std::string title = run_headline(report);
  std::string body = "<p class=\"kicker\">Simulation of <b>" +
                     escaped_name(report.model.emitted.name) + "</b> (" +
                     escaped(report.model.emitted.description) + ") · <code>" +
                     escaped_name(report.what) + "</code></p>\n<h1>" + escaped(title) + "</h1>\n";
  body += model.drawing
              ? stage(model, run_controls(report))
              : "<div class=\"card\">" + run_controls(report) +
                    "<p class=\"small soft\">This kind of model has no drawing.</p></div>\n";
  const std::string first = std::move(body);
  body = diagnosis::section("energy", "Energy",
                            report.books.time.size() < 2
                                ? ""
                                : "<div id=\"energy-plots\" class=\"figures drawn\"></div>\n") +
         slack_section(report) + channel_section(report, groups) +
         "<p class=\"small soft\" id=\"agreement\"></p>\n"
         "<footer><p>Written by sinew simulate.</p></footer>\n";
  return document("Simulation of " + title, first, body, data, graphs);
}

}  // namespace sinew

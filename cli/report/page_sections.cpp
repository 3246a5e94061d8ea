// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report/page_sections.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/report/page_shell.h"
#include "identification/report/page.h"

namespace sinew {
namespace {

using diagnosis::escaped;
using diagnosis::escaped_name;
using diagnosis::section;

std::string plots_at(const std::string& id, const std::string& classes = "") {
  return fmt::format("<div id=\"{}\" class=\"figures drawn{}\"></div>\n", id, classes);
}

std::string millimetres(double metres) {
  return shown(1000.0 * metres);
}

std::string joint_names(const ModelReport& report, std::size_t c) {
  if (!report.drawing || c >= report.drawing->coordinates.size()) return fmt::format("q[{}]", c);
  const DrawnCoordinate& each = report.drawing->coordinates[c];
  const std::string label = each.column.empty() ? each.label : each.column;
  return each.group.empty() ? label : each.group + " " + label;
}

}  // namespace

std::string workspace_section(const ModelReport& report, const std::optional<Reach>& reach) {
  if (!report.drawing || !reach) return "";
  const auto span = [&](int k) {
    return fmt::format("{} to {} mm", millimetres(reach->low[k]), millimetres(reach->high[k]));
  };
  return section(
      "workspace", "Workspace",
      fmt::format(
          "<p>Where the {} over the whole range of all joints: x {}, y {}, z {}; at most {} "
          "mm from the origin. Each dot is one pose of joints spread evenly over their "
          "ranges.</p>\n",
          report.drawing->scene["tips"].size() > 1 ? "fingertips get" : "tip gets", span(0),
          span(1), span(2), millimetres(reach->farthest)) +
          plots_at("workspace-plots", " three"));
}

std::string along_section(const ModelReport& report) {
  if (!report.drawing) return "";
  const bool tips =
      !report.drawing->scene["tips"].empty() && !report.drawing->scene["tips"][0]["fn"].is_null();
  if (report.coupling.empty() && !tips) return "";
  std::string text =
      "<p>Curves along one joint, the others as the sliders above have them; the upright line "
      "marks "
      "the slider.</p>\n<div class=\"choose\"><label for=\"along\">Joint</label><select "
      "id=\"along\"></select></div>\n";
  if (!report.coupling.empty())
    text += "<h3>Tendon lengths and moment arms</h3>\n" + plots_at("tendon-plots");
  if (tips) text += "<h3>Manipulability</h3>\n" + plots_at("manipulability-plots");
  if (tips && !report.stiffness.empty())
    text +=
        "<h3>Stiffness</h3>\n<p>Of the tip, with the motors held, the tensions that hold the pose "
        "and the tendon stiffness of the slider: K = Σ f ∂²h/∂q² + Pᵀ K<sub>t</sub> P, seen at the "
        "tip through the Jacobian.</p>\n" +
        plots_at("stiffness-plots");
  return section("along-one-joint", "Along one joint", text);
}

std::string closure_section(const ModelReport& report, const std::optional<Closure>& closure) {
  if (!closure) return "";
  std::string text = fmt::format(
      "<p>Tendons only pull. Joints are held from all sides where some tensions, all of them above "
      "zero, leave them in balance: Pᵀ f = 0. That is so in <b>{} of {}</b> poses spread over the "
      "joints’ ranges. The coupling matrix has rank {} for {} joints{}.</p>\n",
      closure->closed, closure->poses, closure->lowest_rank, closure->joints,
      closure->lowest_rank < closure->joints ? ": some cannot be moved apart from each other" : "");
  diagnosis::Table table({"Joint", "#Most torque one way", "#Other way"},
                         fmt::format("In the reference pose, no tendon pulling more than {} N",
                                     shown(report.force_high)),
                         true);
  const auto torques = torques_of(report);
  for (std::size_t c = 0; c < torques.size(); ++c)
    table.row({escaped_name(joint_names(report, static_cast<std::size_t>(report.held[c]))),
               shown(torques[c].second) + " N m", shown(torques[c].first) + " N m"});
  return section("force-closure", "Force closure", text + table.html());
}

std::string change_section(const ModelReport& report) {
  if (report.compared_with.empty())
    return section(
        "changes", "Against the previous generation",
        "<p>There is no C of this model yet to compare with: <code>sinew generate</code> "
        "writes it.</p>");
  if (report.changes.empty())
    return section("changes", "Against the previous generation",
                   "<p>The model gives what <code>" + escaped_name(report.compared_with) +
                       "</code> holds: no function changed.</p>");
  diagnosis::Table table({"Function", "Change", "What of it"});
  for (const ChangedFunction& each : report.changes)
    table.row({"<code>" + escaped_name(each.name) + "</code>", escaped(each.change),
               escaped(each.detail)});
  return section("changes", "Against the previous generation",
                 fmt::format("<p>{} from <code>{}</code>. Results: largest change at the reference "
                             "pose.</p>\n",
                             report.changes.size() == 1
                                 ? "One function differs"
                                 : fmt::format("{} functions differ", report.changes.size()),
                             escaped_name(report.compared_with)) +
                     table.html());
}

std::string equation_section(const ModelReport& report) {
  return section(
      "equations", "Equations",
      report.equations.empty() ? "" : "<div class=\"equations\">" + report.equations + "</div>");
}

std::string table_section(const ModelReport& report) {
  std::string text;
  for (const TableOfModel& each : report.tables) {
    diagnosis::Table table(each.headings, each.title);
    for (const std::vector<std::string>& row : each.rows) {
      std::vector<std::string> cells;
      for (const std::string& cell : row) cells.push_back(escaped_name(cell));
      table.row(cells);
    }
    text += table.html();
  }
  std::string warnings;
  for (const std::string& warning : report.warnings)
    warnings += "<li>" + escaped(warning) + "</li>";
  if (!warnings.empty()) text += "<h3>Possible, but hardly meant</h3>\n<ul>" + warnings + "</ul>\n";
  return section("model", "The model", text);
}

std::string missing_section(const ModelReport& report) {
  std::string items;
  for (const std::string& each : report.missing) items += "<li>" + escaped(each) + "</li>\n";
  return section("missing", "What this page does not have",
                 items.empty() ? "" : "<ul>" + items + "</ul>\n");
}

}  // namespace sinew

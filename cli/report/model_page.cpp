// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "cli/report/model_report.h"
#include "cli/report/page_sections.h"
#include "cli/report/page_shell.h"
#include "generator/cost.h"
#include "identification/report/page.h"

namespace sinew {
namespace {

using diagnosis::escaped;
using diagnosis::escaped_name;

struct Facts {
  std::optional<Reach> reach;
  std::optional<Closure> closure;
};

std::size_t tendons_of(const ModelReport& report) {
  return report.drawing ? report.drawing->scene["tendons"].size() : 0;
}

std::string closure_words(const Closure& closure) {
  if (closure.lowest_rank < closure.joints) return "which do not reach every joint";
  if (closure.closed == closure.poses) return "which balance each other in every pose tried";
  return closure.closed == 0 ? "which balance each other in none of the poses tried"
                             : fmt::format("which balance each other in {} of {} poses tried",
                                           closure.closed, closure.poses);
}

/// What there is to say of the model in one sentence.
std::string headline(const ModelReport& report, const Facts& facts) {
  if (!report.drawing)
    return fmt::format("{}: a {} in closed form, {}", report.emitted.name, report.kind,
                       counted(report.emitted.functions.size(), "function", "functions"));
  std::string text = fmt::format("{}: {}", report.emitted.name,
                                 counted(report.drawing->coordinates.size(),
                                         report.drawing->palm.empty() ? "joint" : "coordinate",
                                         report.drawing->palm.empty() ? "joints" : "coordinates"));
  const std::size_t tendons = tendons_of(report);
  text += tendons == 0 ? " without tendons" : " and " + counted(tendons, "tendon", "tendons");
  if (facts.closure) text += ", " + closure_words(*facts.closure);
  if (facts.reach)
    text +=
        fmt::format("; the {} {} mm",
                    report.drawing->scene["tips"].size() > 1 ? "fingertips reach" : "tip reaches",
                    shown(1000.0 * facts.reach->farthest));
  return text;
}

std::string fact(const std::string& name, const std::string& value) {
  return "<div><dt>" + name + "</dt><dd><b>" + value + "</b></dd></div>\n";
}

std::string fact_card(const ModelReport& report) {
  std::string text = fact("Functions emitted", std::to_string(report.emitted.functions.size()));
  for (const auto& [name, title] :
       {std::pair("inverse_dynamics", "Inverse dynamics"), std::pair("bias", "Bias"),
        std::pair("coupling_matrix", "Coupling matrix"),
        std::pair("tendon_jacobian", "Coupling matrix")})
    if (const Graph* graph = function_named(report.emitted, name))
      text += fact(std::string(title) + ", × and +",
                   std::to_string(count_operations(*graph).operations()));
  text += fact("Since the last generation", report.compared_with.empty() ? "never generated"
                                            : report.changes.empty()
                                                ? "no change"
                                                : fmt::format("{} changed", report.changes.size()));
  return "<div class=\"card\"><dl class=\"facts\">\n" + text + "</dl></div>\n";
}

std::string pose_buttons(const ModelReport& report) {
  std::string text =
      "<div class=\"buttons\"><button id=\"pose-reference\" type=\"button\">Reference pose</button>"
      "<button id=\"pose-zero\" type=\"button\">All zero</button>"
      "<button id=\"pose-next\" type=\"button\">Another pose</button></div>\n"
      "<div class=\"buttons\">";
  const bool tips = !report.drawing->scene["tips"].empty();
  if (tips && report.drawing->palm.size() != report.drawing->coordinates.size())
    text +=
        "<button id=\"show-reach\" type=\"button\" aria-pressed=\"false\">Show workspace</button>";
  if (!report.stiffness.empty() && tips && !report.drawing->scene["tips"][0]["fn"].is_null())
    text +=
        "<button id=\"show-ellipse\" type=\"button\" aria-pressed=\"true\">Stiffness ellipse"
        "</button>";
  return text + "</div>\n";
}

std::string slider_row(const std::string& id, const std::string& label, double low, double high,
                       double value) {
  return fmt::format(
      "<div class=\"slider\"><label for=\"{0}\">{1}</label><input type=\"range\" id=\"{0}\" "
      "min=\"{2:g}\" max=\"{3:g}\" step=\"any\" value=\"{4:g}\"><output for=\"{0}\" "
      "id=\"{0}-told\"></output></div>\n",
      id, label, low, high, value);
}

std::string force_controls(const ModelReport& report) {
  if (report.coupling.empty()) return "";
  std::string text =
      "<fieldset><legend>Tendons</legend>\n" +
      slider_row("least", "Least tension", 0.0, 0.5 * report.force_high, 0.15 * report.force_high);
  if (!report.stiffness.empty())
    text += slider_row("stiffness", "Stiffness", report.stiffness_low / 1000.0,
                       report.stiffness_high / 1000.0,
                       std::sqrt(report.stiffness_low * report.stiffness_high) / 1000.0);
  const bool weighs = !report.gravity.empty() || !report.weighed.torques.empty();
  if (weighs)
    text +=
        "<p><label><input type=\"checkbox\" id=\"weight\" checked> They carry the bodies’ "
        "weight</label></p>\n";
  return text +
         "</fieldset>\n<p class=\"small soft\">Colours: the smallest tensions, none below the "
         "least "
         "one, that hold the pose" +
         (!weighs && !report.held.empty() ? ", the bodies’ weight left out" : "") +
         ". <span id=\"magnified\"></span></p>\n";
}

std::string controls(const ModelReport& report) {
  const bool many = report.drawing->coordinates.size() > 10;
  return pose_buttons(report) + "<div id=\"sliders\"" + (many ? " class=\"many\"" : "") +
         "></div>\n" + force_controls(report) + "<dl id=\"readout\" class=\"facts\"></dl>\n";
}

/// Of a model without bodies: what its functions give.
std::string curves() {
  return "<div class=\"card\"><div class=\"choose\"><label "
         "for=\"curve-function\">Function</label><select "
         "id=\"curve-function\"></select><label for=\"curve-input\">over</label><select "
         "id=\"curve-input\"></select></div>\n<div id=\"curve-plots\" class=\"figures "
         "drawn\"></div></div>\n";
}

std::string contents(const std::string& body) {
  std::string items;
  for (const auto& [id, name] :
       {std::pair("workspace", "Workspace"), std::pair("along-one-joint", "Along one joint"),
        std::pair("force-closure", "Force closure"), std::pair("functions", "Functions"),
        std::pair("changes", "Changes"), std::pair("equations", "Equations"),
        std::pair("model", "The model"), std::pair("missing", "Not here")})
    if (body.find(fmt::format("<section id=\"{}\"", id)) != std::string::npos)
      items += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, name);
  return "<nav aria-label=\"Sections\"><ul class=\"toc\">\n" + items + "</ul></nav>\n";
}

}  // namespace

std::string model_page(const ModelReport& report) {
  const Facts facts{reach_of(report), closure_of(report)};
  std::vector<std::string> left_out;
  const std::vector<Graph> graphs = functions_of_page(report, left_out);
  const std::string title = headline(report, facts);
  std::string first = "<p class=\"kicker\">Model <b>" + escaped_name(report.emitted.name) +
                      "</b> (" + escaped(report.emitted.description) + ") · " +
                      escaped(report.kind) + " · from <code>" + escaped_name(report.folder) +
                      "</code></p>\n<h1>" + escaped(title) + "</h1>\n";
  first += report.drawing ? stage(report, controls(report)) : curves();
  first += "<div class=\"pair\" style=\"margin-top:1rem\">" + fact_card(report) + "</div>\n";
  const std::string body = workspace_section(report, facts.reach) + along_section(report) +
                           closure_section(report, facts.closure) +
                           function_section(report, left_out) + change_section(report) +
                           equation_section(report) + table_section(report) +
                           missing_section(report);
  return document("Model " + title, first + contents(body),
                  body + fmt::format("<footer><p>Written by sinew report. Model: "
                                     "sha256 {}.</p></footer>\n",
                                     report.emitted.hash),
                  data_of(report, graphs), graphs);
}

}  // namespace sinew
